// Texts that several tests of scenes start from.
#pragma once

#include <functional>
#include <string>
#include <sulfur/scene.hpp>

namespace sulfur::scene::testing {

/// Uses every member that the format knows, with unusual values, and unknown members everywhere.
inline const std::string fullScene = R"({
  "format": "sulfur-scene",
  "version": 1,
  "title": "Everything \"at once\"\n\u00e9\u2603",
  "description": "A line\tand\\another",
  "world": {"gravity": [0.5, -3.7], "airFriction": 0.02, "tickRate": 240, "sleeping": false,
            "sweeps": 7, "friction": "sliding", "sleepSpeed": 0.25, "reboundSpeed": 0.5, "wind": [1, 2]},
  "blueprints": {
    "plain": {
      "kind": "kinematic",
      "particles": [
        {"position": [0, 0], "mass": 0.1, "radius": 0.3, "pinned": true, "tint": "red"},
        {"position": [1, 0.1]},
        {"position": [0, 1]}
      ],
      "joints": [
        {"a": 0, "b": 1, "stiffness": 123.456, "damping": 0.7, "restLength": 1.5, "radius": 0.01,
         "strength": 900, "tag": {"deep": [1, 2.50, -0e1]}},
        {"a": 1, "b": 2, "stiffness": "rigid", "strength": "unbreakable", "radius": 0.02, "bend": -0.5,
         "material": {"kineticFriction": 0.3, "surfaceSpeed": -2.5, "slick": 1}}
      ],
      "angles": [
        {"a": 0, "b": 1, "c": 2, "stiffness": 12.5, "damping": 0.25, "restAngle": -1.5, "lower": -2,
         "upper": 1, "motorSpeed": 3, "motorMax": 40, "motorTarget": -0.5, "strength": 60, "why": []}
      ],
      "material": {"staticFriction": 0.9, "kineticFriction": 0.8, "restitution": 0.7,
                   "surfaceSpeed": 1.5, "rollingResistance": 0.25, "wet": true},
      "filter": {"category": 2, "mask": 4294967294, "group": -3, "why": null},
      "selfCollision": true,
      "skin": {"texture": "art/plain.png", "uv": [[0, 1], [1, 1], [0, 0]],
               "triangles": [[0, 1, 2]], "blend": 1},
      "note": "kept"
    },
    "floor": {"shape": "floor", "from": [-20, 0], "to": [20, 0.5], "radius": 0.1,
              "material": {"restitution": 0.25}},
    "ground": {"shape": "ground", "points": [[0, 0], [3, 1], [5, -1]], "closed": true,
               "radius": 0.2, "material": {"kineticFriction": 0.1}, "bends": [0.5, -1, 0.25]},
    "box": {"shape": "box", "size": [1.5, 0.75], "mass": 2.5, "radius": 0.03, "stiffness": 5000,
            "damping": 0.5, "strength": 77, "solidInertia": false, "rounded": true, "kind": "dynamic",
            "material": {"restitution": 0.1}, "filter": {"group": 5}, "sensor": true,
            "skin": {"texture": "box.png"}},
    "ball": {"shape": "ball", "radius": 0.4, "mass": 3, "material": {"restitution": 1}},
    "rope": {"shape": "rope", "from": [1, 2], "to": [4, 6], "links": 9, "bending": 2.5, "mass": 0.9, "radius": 0,
             "bendingDamping": 2, "stiffness": 800, "damping": 0.2, "strength": 500, "pinFirst": true, "pinLast": true,
             "selfCollision": true, "material": {"staticFriction": 2}},
    "jelly": {"shape": "jelly", "size": [2, 1], "columns": 5, "rows": 3, "mass": 4,
              "radius": 0.05, "stiffness": 300, "damping": 2, "strength": 99,
              "material": {"restitution": 0.3}, "skin": {"texture": "j.png"}},
    "blob": {"shape": "blob", "radius": 0.6, "segments": 9, "mass": 1.5, "skinRadius": 0.04,
             "stiffness": 700, "damping": 1, "material": {"restitution": 0.2}, "kind": "dynamic"},
    "polygon": {"shape": "polygon", "points": [[0, 0], [2, 0], [0.5, 0.5], [0, 2]], "mass": 1.25,
                "radius": 0.04, "stiffness": 900, "damping": 3, "strength": 70, "rounded": true,
                "material": {"restitution": 0.6}},
    "wheel": {"shape": "wheel", "radius": 0.7, "segments": 10, "mass": 2.25, "rimRadius": 0.05,
              "spokeStiffness": 4000, "spokeDamping": 6, "strength": 800,
              "material": {"restitution": 0.65}, "skin": {"texture": "w.png"}},
    "chain": {"shape": "chain", "from": [0, 3], "to": [1, 4], "links": 5, "mass": 3, "radius": 0,
              "strength": 4500, "pinFirst": true, "pinLast": true,
              "material": {"staticFriction": 3}},
    "bridge": {"shape": "bridge", "from": [-1, 2], "to": [3, 2.5], "planks": 7, "sag": 0.1,
               "mass": 14, "radius": 0.07, "stiffness": 80000, "damping": 9, "strength": 6000,
               "material": {"staticFriction": 1.5}},
    "cloth": {"shape": "cloth", "size": [1, 1.5], "columns": 4, "rows": 6, "mass": 0.75,
              "radius": 0.02, "diagonals": true, "pinCorners": false, "stiffness": 300,
              "damping": 0.5, "strength": 90, "material": {"restitution": 0.05},
              "skin": {"texture": "c.png"}},
    "wall": {"shape": "wall", "size": [3, 2], "columns": 4, "rows": 2, "mass": 70, "radius": 0.03,
             "stiffness": 1000000, "damping": 8, "strength": 900, "pinBottom": true,
             "material": {"staticFriction": 0.95}, "skin": {"texture": "b.png"}}
  },
  "bodies": [
    {"id": "ground", "blueprint": "floor", "layer": 3},
    {"id": "lift", "blueprint": "plain", "position": [3, 4.25], "angle": 0.5, "velocity": [0, 1],
     "kind": "dynamic", "material": {"restitution": 0.5}, "filter": {"mask": 1},
     "sensor": true},
    {"id": "b", "blueprint": "blob", "position": [-3, 6]},
    {"id": "r", "blueprint": "rope"},
    {"id": "crate", "blueprint": "box", "position": [8, 2],
     "state": {"positions": [[7.3, 2], [8.7, 2], [8.7, 2.6], [7.3, 2.6]],
               "velocities": [[1, 0], [1, 0], [1, 0.125], [1, 0]], "when": 1}}
  ],
  "connections": [
    {"a": ["b", 0], "b": ["crate", 3], "stiffness": 40, "damping": 1, "restLength": 2,
     "radius": 0.02, "strength": 3000, "material": {"restitution": 0.45, "worn": 2}, "colour": "blue"}
  ],
  "attachments": [
    {"particle": ["r", 4], "body": "crate", "point": [0.25, -0.1], "hook": []}
  ],
  "vetoes": [["b", "lift"], ["crate", "ground"]],
  "fields": [
    {"type": "uniform", "zone": {"low": [-3, -2.5], "high": [3, 2], "tint": 1},
     "acceleration": [0.5, 12], "mask": 6, "flow": "river"},
    {"type": "radial", "centre": [20, 5], "strength": -30, "falloff": 1, "core": 0.5, "reach": 8,
     "mask": 3},
    {"type": "wind", "zone": {"centre": [5, 6], "radius": 4.5}, "velocity": [3, -1], "drag": 2.5,
     "mask": 1},
    {"type": "wind", "velocity": [0.25, 0]}
  ],
  "mechanisms": [
    {"type": "hinge", "id": "turn", "a": "lift", "b": "crate", "at": [8, 2.3], "collide": true,
     "pin": false, "strength": 40, "value": 0.25, "paint": "red",
     "drive": {"lower": -1.5, "upper": 2.5, "stiffness": 30, "damping": 2, "rest": 0.1,
               "motorSpeed": 3, "motorMax": 25, "motorTarget": 0.5, "strength": 90, "oil": 1}},
    {"type": "weld", "id": "bracket", "a": "ground", "b": "lift", "at": [3, 4], "stiffness": 500,
     "damping": 5, "collide": true, "strength": 800, "torqueStrength": 70, "value": 0.125,
     "drive": {"stiffness": 500, "upper": 1}},
    {"type": "slider", "id": "rail", "a": "ground", "b": "b", "at": [-3, 6], "axis": [0, 2],
     "collide": true, "turns": false, "value": -0.5, "drive": {"lower": -4, "motorMax": "unlimited"}},
    {"type": "wheel", "id": "axle", "a": "lift", "b": "crate", "at": [8, 2.3], "axis": [1, 1],
     "collide": true, "spring": {"stiffness": 200}, "motor": {"motorSpeed": 5, "motorMax": 3}},
    {"type": "distance", "id": "line", "a": "b", "b": "r", "atA": [-3, 6], "atB": [1, 2],
     "collide": false, "drive": {"upper": 12}},
    {"type": "pulley", "id": "lines", "a": "b", "b": "crate", "frame": "ground", "atA": [-3, 6],
     "atB": [8.7, 2.6], "overA": [-3, 9], "overB": [8.5, 9], "ratio": 2, "length": 30,
     "strength": 5000, "drive": {"upper": 31}},
    {"type": "gear", "id": "mesh", "first": "turn", "second": "axle", "ratio": -2.5,
     "drive": {"stiffness": "rigid", "strength": 60}}
  ],
  "level": {
    "spawn": [1, 2],
    "exit": {"id": "door", "at": [9, 9]}
  }
}
)";

/// The error that `run` throws, or one with an empty message when it throws none.
inline ReadError errorOf(const std::function<void()>& run) {
    try {
        run();
    } catch (const ReadError& error) {
        return error;
    }
    return ReadError("", 0, "", "");
}

inline ReadError errorOf(const std::string& text) {
    return errorOf([&] { parse(text, "test.json"); });
}

/// `text` with its only `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
        throw std::logic_error("not there exactly once: " + from);
    return text.replace(at, from.size(), to);
}

}  // namespace sulfur::scene::testing
