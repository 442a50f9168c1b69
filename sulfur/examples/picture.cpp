#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <string>
#include <utility>

using namespace sulfur;

namespace {

constexpr double width = 720;        // pixels
constexpr double thin = 1.2;         // pixels
constexpr double groundDepth = 0.6;  // m that are tinted below ground
constexpr const char* paper = "#fbfaf6";

}  // namespace

const std::array<Picture::Look, 9> Picture::looks{{{"blue", "#2f62a0", "#a9c8ea"},
                                                   {"orange", "#c8701b", "#f8d09c"},
                                                   {"green", "#2f7d52", "#a8d9bc"},
                                                   {"pink", "#a94a80", "#ecc0da"},
                                                   {"teal", "#1f7f8c", "#a3dce3"},
                                                   {"red", "#b8452d", "#f3b7a7"},
                                                   {"violet", "#5e4a9c", "#cabfea"},
                                                   {"gold", "#9a7a16", "#efdf9c"},
                                                   {"grey", "#4d5560", "#c3c8cf"}}};

Picture::Picture(int argc, char** argv, Point low, Point high)
    : low_(low), high_(high), scale_(width / (high.x() - low.x())) {
    if (argc < 2) return;
    file_.open(argv[1]);
    if (!file_) {
        std::fprintf(stderr, "%s: cannot open %s\n", argv[0], argv[1]);
        std::exit(2);
    }
    for (std::ostringstream* out : {&svg_, &links_}) {
        out->precision(1);
        *out << std::fixed;
    }
}

Picture::~Picture() {
    if (!file_.is_open()) return;
    const double height = (high_.y() - low_.y()) * scale_;
    file_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
          << height << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"" << paper << "\"/>\n"
          << svg_.str()  //
          << "<path d=\"M20 32v-6h" << scale_ << "v6\" fill=\"none\" stroke=\"#8b8f96\"/>\n"
          << "<text x=\"" << 26 + scale_
          << "\" y=\"32\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#8b8f96\">1 m</text>\n"
          << "</svg>\n";
}

void Picture::paint(BodyId body, const char* colour) {
    const auto found = std::find_if(looks.begin(), looks.end(), [&](const Look& look) {
        return std::string(look.name) == colour;
    });
    look_[body] = found == looks.end() ? &looks.back() : &*found;
}

void Picture::take(const World& world, double opacity) {
    if (!file_.is_open() || opacity <= 0) return;
    world_ = &world;
    svg_ << "<g opacity=\"" << opacity << "\">\n";
    world.draw(*this);
    finishBody();
    svg_ << "<path fill=\"none\" stroke=\"" << looks.back().dark << "\" d=\"" << links_.str()
         << "\"/>\n</g>\n";
    links_.str("");
}

void Picture::line(Point a, Point b, double opacity) {
    svg_ << "<g opacity=\"" << opacity << "\">";
    stroke(a, b, thin, "#c8701b");
    svg_ << "</g>\n";
}

void Picture::dot(Point centre, double opacity) {
    if (opacity <= 0) return;
    svg_ << "<g opacity=\"" << opacity << "\">";
    circle(centre, 2.5, "#b8452d", "none");
    svg_ << "</g>\n";
}

// --- what World::draw shows ----------------------------------------------------------------------

void Picture::body(const Body& b) {
    finishBody();
    body_ = b.id;
    if (look_.count(b.id) == 0)
        look_[b.id] = b.kind == BodyKind::dynamic ? &looks[next_++ % 8] : &looks.back();
}

void Picture::capsule(const Capsule& c) {
    const double pixels = std::max(thin, 2 * static_cast<double>(c.radius) * scale_);
    const JointInfo info = world_->info(c.id);
    if (c.body)
        sides_.push_back({info.a, info.b, c.a, c.b, pixels});
    else
        stroke(c.a, c.b, pixels, looks.back().dark);
}

void Picture::joint(const Joint& j) {
    if (world_->info(j.id).radius > 0) return;
    if (j.body)
        bones_.push_back(j);
    else
        links_ << "M" << x(j.a) << " " << y(j.a) << "L" << x(j.b) << " " << y(j.b);
}

void Picture::disc(const Disc& d) {
    finishBody();
    const Look& look = *look_[d.body];
    const double r = static_cast<double>(d.radius);
    circle(d.centre, r * scale_ - thin / 2, look.light, look.dark);
    if (world_->kind(d.body) != BodyKind::dynamic || world_->particles(d.body).size() > 1) return;
    const double angle = world_->info(d.id).angle;
    stroke(d.centre, d.centre + 0.8 * r * Point(std::cos(angle), std::sin(angle)), thin, look.dark);
}

void Picture::particle(const Particle& p) {
    finishBody();
    if (p.pinned && world_->kind(p.body) == BodyKind::dynamic)
        circle(p.place, 4, paper, looks.back().dark);
}

void Picture::attachment(const Attachment& a) {
    circle(a.particle, 3, paper, looks.back().dark);
}

void Picture::grab(const Grab& g) {
    stroke(g.info.point, g.info.target, thin, looks[5].dark);
    circle(g.info.target, 4, paper, looks[5].dark);
}

// --- shapes
// ----------------------------------------------------------------------------------------

/// Draws what was gathered of a body: its inside, its joints, then its capsules on top.
void Picture::finishBody() {
    if (sides_.empty() && bones_.empty()) return;
    const bool sensor = world_->sensor(body_);
    const bool ground = !sensor && bones_.empty() && world_->kind(body_) == BodyKind::fixed;
    if (sensor || ground) {
        if (ground && world_->filter(body_).mask != 0) tintGround();
        drawSides(sensor ? "\" stroke-opacity=\"0.4\" stroke-dasharray=\"1 8" : "");
    } else if (drawLoop()) {
        drawBones(true);
    } else {
        drawBones(fillTriangles());
        drawSides("");
    }
    sides_.clear();
    bones_.clear();
}

/// Springs of soft bodies, and threads of open ones; not the braces of what is rigid.
void Picture::drawBones(bool solid) {
    if (solid && bones_.size() > 150) return;  // too fine to be seen
    std::ostringstream lines;
    lines << std::fixed << std::setprecision(1);
    for (const Joint& bone : bones_)
        if (!solid || bone.stiffness < infinite)
            lines << "M" << x(bone.a) << " " << y(bone.a) << "L" << x(bone.b) << " " << y(bone.b);
    if (lines.str().empty()) return;
    svg_ << "<path stroke=\"" << look_[body_]->dark << "\" stroke-width=\"" << (solid ? 0.5 : thin)
         << "\" d=\"" << lines.str() << "\"/>\n";
}

/// All capsules of a body, as few lines.
void Picture::drawSides(const char* style) {
    const Side* last = nullptr;
    for (const Side& side : sides_) {
        if (last == nullptr || side.pixels != last->pixels)
            svg_ << (last == nullptr ? "" : "\"/>\n") << "<path fill=\"none\" stroke=\""
                 << look_[body_]->dark << "\" stroke-width=\"" << side.pixels << style << "\" d=\"";
        if (last == nullptr || side.pixels != last->pixels || side.a != last->b)
            svg_ << "M" << x(side.from) << " " << y(side.from);
        svg_ << "L" << x(side.to) << " " << y(side.to);
        last = &side;
    }
    if (last != nullptr) svg_ << "\"/>\n";
}

/// The ground lies to the right of its line.
void Picture::tintGround() {
    svg_ << "<path fill=\"#e4e1d8\" d=\"";
    for (const Side& side : sides_) {
        const Point along = side.to - side.from;
        const Point deeper = std::abs(along.x()) > std::abs(along.y())
                                 ? Point(0, std::copysign(groundDepth, -along.x()))
                                 : Point(std::copysign(groundDepth, along.y()), 0);
        corners({side.from, side.to, side.to + deeper, side.from + deeper});
    }
    svg_ << "\"/>\n";
}

/// Where the capsules go round in one loop: draws them, filled.
bool Picture::drawLoop() {
    if (sides_.empty()) return false;
    std::map<ParticleId, std::vector<const Side*>> at;
    for (const Side& side : sides_) {
        at[side.a].push_back(&side);
        at[side.b].push_back(&side);
    }
    for (const auto& [corner, sides] : at)
        if (sides.size() != 2) return false;
    Loop loop;
    const Side* side = &sides_.front();
    ParticleId corner = side->a;
    do {
        loop.push_back(side->a == corner ? side->from : side->to);
        corner = side->a == corner ? side->b : side->a;
        side = at[corner][at[corner][0] == side ? 1 : 0];
    } while (side != &sides_.front());
    svg_ << "<path fill=\"" << look_[body_]->light << "\" stroke=\"" << look_[body_]->dark
         << "\" stroke-width=\"" << sides_.front().pixels << "\" d=\"";
    corners(loop);
    svg_ << "\"/>\n";
    return true;
}

/// Fills every triangle of joints, with which solid bodies are braced.
bool Picture::fillTriangles() {
    std::map<ParticleId, std::vector<ParticleId>> next;
    for (const JointId id : world_->joints(body_)) {
        const JointInfo joint = world_->info(id);
        next[std::min(joint.a, joint.b)].push_back(std::max(joint.a, joint.b));
    }
    std::vector<Loop> triangles;
    for (const auto& [a, others] : next)
        for (const ParticleId b : others)
            for (const ParticleId c : next[b])
                if (std::count(others.begin(), others.end(), c) > 0)
                    triangles.push_back(
                        {world_->position(a), world_->position(b), world_->position(c)});
    if (triangles.empty()) return false;
    svg_ << "<path fill=\"" << look_[body_]->light << "\" d=\"";
    for (Loop& triangle : triangles) {  // all one way round, so that what overlaps is filled too
        if (cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0)
            std::swap(triangle[1], triangle[2]);
        corners(triangle);
    }
    svg_ << "\"/>\n";
    return true;
}

void Picture::corners(const Loop& loop) {
    char pen = 'M';
    for (const Point& corner : loop) {
        svg_ << pen << x(corner) << " " << y(corner);
        pen = 'L';
    }
    svg_ << "z";
}

void Picture::stroke(Point a, Point b, double pixels, const char* colour) {
    svg_ << "<path d=\"M" << x(a) << " " << y(a) << "L" << x(b) << " " << y(b) << "\" stroke=\""
         << colour << "\" stroke-width=\"" << pixels << "\"/>\n";
}

void Picture::circle(Point centre, double pixels, const char* fill, const char* edge) {
    svg_ << "<circle cx=\"" << x(centre) << "\" cy=\"" << y(centre) << "\" r=\"" << pixels
         << "\" fill=\"" << fill << "\" stroke=\"" << edge << "\" stroke-width=\"" << thin
         << "\"/>\n";
}
