// Templates: small scenes with a name that are placed again and again, and what in a scene says
// which bodies are an instance of which one.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <sulfur/scene.hpp>
#include <vector>

#include "geometry.hpp"

namespace sulfurchamber {

/// A scene whose bodies are the parts of something. Its title is the template's name; its origin is
/// in the middle of its lower edge.
struct Template {
    std::string category;  ///< for people; "Other" where a file names none
    sulfur::scene::Scene scene;

    const std::string& name() const { return scene.title; }
};

/// Takes any scene as a template. Throws std::runtime_error when it has no name or no body.
Template readTemplate(sulfur::scene::Scene scene);
/// The text of its file.
std::string textOf(const Template& made);
/// What it covers, at rest; nothing where its parts have no extent.
Bounds boundsOf(const sulfur::scene::Scene& scene);
/// Moves all of a scene by metres.
void moveScene(sulfur::scene::Scene& scene, const sulfur::Point& by);

/// Of which instance a body is which part. Files keep it as a member "template" of the body.
struct Membership {
    std::string name;      ///< of the template
    std::string instance;  ///< unique in a scene
    std::string part;      ///< id of the part in the template
};
std::optional<Membership> membershipOf(const sulfur::scene::Placement& body);
void setMembership(sulfur::scene::Placement& body, const Membership& membership);
void clearMembership(sulfur::scene::Placement& body);

/// One instance in a scene.
struct Instance {
    std::string name;                        ///< of the template
    std::string instance;                    ///< its own
    std::map<std::string, std::string> ids;  ///< of bodies, by part
};
/// In the order of their first bodies.
std::vector<Instance> instancesOf(const sulfur::scene::Scene& scene);
/// A name for another instance of a template.
std::string freeInstance(const sulfur::scene::Scene& scene, const std::string& name);

// A scene carries the templates of its instances in its member "templates", by name: it follows
// these, wherever it is opened.

/// Null where the scene has none of this name, or one that cannot be read.
std::optional<Template> definition(const sulfur::scene::Scene& scene, const std::string& name);
/// Their names.
std::vector<std::string> definitions(const sulfur::scene::Scene& scene);
/// Adds one or replaces that of this name; the instances stay as they are.
void define(sulfur::scene::Scene& scene, const Template& made);
/// Takes out those that no body is an instance of.
void forgetUnusedDefinitions(sulfur::scene::Scene& scene);
/// Takes over the definitions of another scene whose names are free here.
void takeDefinitions(sulfur::scene::Scene& into, const sulfur::scene::Scene& from);

/// Gives each mechanism of a scene an id, so that instances can be compared with it.
void nameMechanisms(sulfur::scene::Scene& scene);
/// Which mechanism of its template one is; its own id where it comes from none.
std::string partOf(const sulfur::scene::SceneMechanism& mechanism);
void setPart(sulfur::scene::SceneMechanism& mechanism, const std::string& part);

/// A pose in the frame of another one, which is in the world, and back.
sulfur::Pose composed(const sulfur::Pose& frame, const sulfur::Pose& local);
sulfur::Pose inverse(const sulfur::Pose& frame);
/// Takes a body from a frame to the world.
void carry(sulfur::scene::Placement& body, const sulfur::Pose& frame);
/// The same for all points of a mechanism.
void carry(sulfur::scene::SceneMechanism& mechanism, const sulfur::Pose& frame);

/// A text as a JSON string.
std::string jsonString(std::string_view text);

}  // namespace sulfurchamber
