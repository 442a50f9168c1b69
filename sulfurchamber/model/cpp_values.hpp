// Values of libsulfur's public structs as C++ expressions, in the namespace sulfur. Of structs only
// what differs from their defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <sulfur/scene.hpp>
#include <type_traits>
#include <vector>

namespace sulfurchamber::cpp {

std::string text(float value);
std::string text(double value);
std::string text(int value);
std::string text(std::uint32_t value);
std::string text(bool value);
std::string text(const std::string& value);
template <class Number>  // places are of double, differences of Real, which may be the same
std::string text(const Eigen::Matrix<Number, 2, 1, Eigen::DontAlign>& value) {
    return std::string(std::is_same_v<Number, sulfur::Real> ? "Vec2(" : "Point(") +
           text(value.x()) + ", " + text(value.y()) + ")";
}
std::string text(const std::vector<sulfur::Vec2>& value);
std::string text(const std::vector<sulfur::Real>& value);
std::string text(const sulfur::Pose& value);
std::string text(sulfur::BodyKind value);
std::string text(sulfur::Damper value);
std::string text(sulfur::Friction value);
std::string text(const sulfur::Material& value);
std::string text(const sulfur::Filter& value);
std::string text(const sulfur::Drive& value);
std::string text(const sulfur::ConnectOptions& value);
std::string text(const sulfur::HingeOptions& value);
std::string text(const sulfur::SliderOptions& value);
std::string text(const sulfur::WheelOptions& value);
std::string text(const sulfur::WeldOptions& value);
std::string text(const sulfur::DistanceOptions& value);
std::string text(const sulfur::PulleyOptions& value);
std::string text(const sulfur::WorldSettings& value);
std::string text(const sulfur::ParticleSpec& value);
std::string text(const sulfur::JointSpec& value);
std::string text(const sulfur::AngularJointSpec& value);
std::string text(const sulfur::Field& value);
/// The call that makes a blueprint; "" where there is no recipe.
std::string text(const sulfur::scene::Generator& value);

template <class T>
std::string text(const std::optional<T>& value) {
    return value ? text(*value) : "std::nullopt";
}
/// One element a line, `indent` spaces deep.
template <class T>
std::string lines(const std::vector<T>& values, std::size_t indent) {
    std::string all = "{";
    for (const T& value : values) all += "\n" + std::string(indent + 4, ' ') + text(value) + ",";
    return all + "\n" + std::string(indent, ' ') + "}";
}

}  // namespace sulfurchamber::cpp
