#include "icons.hpp"

#include <wx/settings.h>

#include <array>
#include <string>
#include <utility>

namespace sulfurchamber {
namespace {

using Icon = std::pair<std::string_view, std::string_view>;

// Shapes in a box of 24 by 24. They inherit the stroke; "ACCENT" and "INK" become colours.
constexpr std::array<Icon, 77> icons{
    {
        {"new", R"(<path d="M6 3h8l5 5v13H6z"/><path d="M14 3v5h5"/>)"},
        {"open",
         R"(<path d="M3 19V5h6l2 3h8v3"/><path d="M3 19l3-8h16l-3 8z" fill="ACCENT" fill-opacity="0.25"/>)"},
        {"save",
         R"(<path d="M4 4h13l3 3v13H4z"/><path d="M8 4v5h7V4"/><path d="M7 20v-7h10v7" fill="ACCENT" fill-opacity="0.3"/>)"},
        {"undo", R"(<path d="M9 5L4 10l5 5"/><path d="M4 10h10a6 5 0 0 1 0 10h-3"/>)"},
        {"redo", R"(<path d="M15 5l5 5-5 5"/><path d="M20 10H10a6 5 0 0 0 0 10h3"/>)"},
        {"play", R"(<path d="M7 4l13 8-13 8z" fill="ACCENT" stroke="ACCENT"/>)"},
        {"pause", R"(<path d="M8 5v14M16 5v14" stroke="ACCENT" stroke-width="4"/>)"},
        {"tick",
         R"(<path d="M5 5l9 7-9 7z" fill="ACCENT" fill-opacity="0.35"/><path d="M18 5v14" stroke-width="2.6"/>)"},
        {"back",
         R"(<path d="M19 5l-9 7 9 7z" fill="ACCENT" fill-opacity="0.35"/><path d="M6 5v14" stroke-width="2.6"/>)"},
        {"reset",
         R"(<path d="M4 5v14" stroke-width="2.6"/><path d="M12 5l-6 7 6 7zM20 5l-7 7 7 7z" fill="ACCENT" fill-opacity="0.35"/>)"},
        {"fit",
         R"(<path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"/><rect x="9" y="9" width="6" height="6" fill="ACCENT" stroke="none"/>)"},
        {"grid", R"(<path d="M4 4h16v16H4zM4 12h16M12 4v16"/>)"},
        {"arrows",
         R"(<circle cx="6" cy="18" r="2.6" fill="INK"/><path d="M8 16L20 4M13 4h7v7" stroke="ACCENT"/>)"},
        {"strain", R"(<path d="M3 12h3l2-5 4 10 4-10 2 5h3" stroke="ACCENT"/>)"},
        {"slow",
         R"(<circle cx="12" cy="13" r="8"/><path d="M12 8v5l4 2" stroke="ACCENT"/><path d="M9 2h6"/>)"},
        {"select",
         R"(<path d="M6 3l13 9-6 1.4L17 20l-2.6 1.4L11 15l-5 4z" fill="INK" fill-opacity="0.2"/>)"},
        {"box",
         R"(<rect x="5" y="5" width="14" height="14" rx="1" fill="ACCENT" fill-opacity="0.3"/><path d="M5 5l14 14M19 5L5 19" stroke-opacity="0.5" stroke-width="1"/>)"},
        {"ball",
         R"(<circle cx="12" cy="12" r="8" fill="ACCENT" fill-opacity="0.3"/><circle cx="9.5" cy="9.5" r="1.6" fill="INK" stroke="none"/>)"},
        {"jelly",
         R"(<path d="M5 20C3 14 4 7 8 6c3-1 6 1 9 0 3 2 4 9 2 14-5 1-9 1-14 0z" fill="#FFB347" fill-opacity="0.4" stroke="#FFB347"/><circle cx="9" cy="13" r="1.2" fill="INK" stroke="none"/><circle cx="15" cy="13" r="1.2" fill="INK" stroke="none"/>)"},
        {"rope",
         R"(<path d="M4 4c6 1 1 8 7 9s2 7 9 7"/><circle cx="4" cy="4" r="2" fill="ACCENT" stroke="none"/>)"},
        {"wheel",
         R"(<circle cx="12" cy="12" r="8" fill="ACCENT" fill-opacity="0.2"/><circle cx="12" cy="12" r="2" fill="INK"/><path d="M12 4v16M4 12h16" stroke-opacity="0.6"/>)"},
        {"polygon", R"(<path d="M4 19L7 6l7 5 6-6-2 14z" fill="ACCENT" fill-opacity="0.3"/>)"},
        {"draw",
         R"(<path d="M5 18c-3-8 4-7 5-11s8-3 8 2-1 9-6 10-5 2-7-1z" fill="#FFB347" fill-opacity="0.4" stroke="#FFB347"/><path d="M14 10l7-7" stroke-width="2.4"/>)"},
        {"chain",
         R"(<rect x="3" y="3" width="6" height="9" rx="3"/><rect x="9" y="8" width="6" height="9" rx="3" stroke="ACCENT"/><rect x="15" y="13" width="6" height="9" rx="3"/>)"},
        {"bridge",
         R"(<path d="M2 8c6 8 14 8 20 0" stroke="ACCENT" stroke-width="2.8"/><path d="M2 8v12M22 8v12"/>)"},
        {"cloth",
         R"(<path d="M4 4c5 2 11 2 16 0v14c-5 3-11 3-16 0zM4 9c5 2 11 2 16 0M4 14c5 2 11 2 16 0M9 5v15M15 5v15" stroke="#FFB347"/>)"},
        {"wall",
         R"(<path d="M4 5h16v14H4zM4 9.7h16M4 14.3h16M9 5v4.7M15 5v4.7M12 9.7v4.6M9 14.3V19M15 14.3V19"/>)"},
        {"particle",
         R"(<circle cx="12" cy="12" r="4" fill="ACCENT" stroke="none"/><path d="M12 3v3M12 18v3M3 12h3M18 12h3" stroke-opacity="0.6"/>)"},
        {"joint",
         R"(<path d="M6 18L18 6" stroke="ACCENT" stroke-width="2.4"/><circle cx="6" cy="18" r="3" fill="INK"/><circle cx="18" cy="6" r="3" fill="INK"/>)"},
        {"ground",
         R"(<path d="M2 12h20" stroke-width="2.8"/><path d="M5 13l-3 5M11 13l-3 5M17 13l-3 5M22 14l-2 4" stroke-opacity="0.6"/>)"},
        {"pin",
         R"(<circle cx="12" cy="8" r="5" fill="#FFB347" fill-opacity="0.5"/><path d="M12 13v8"/>)"},
        {"cut",
         R"(<circle cx="6" cy="18" r="2.7"/><circle cx="18" cy="18" r="2.7"/><path d="M8 16L17 3M16 16L7 3"/>)"},
        {"erase",
         R"(<path d="M4 15L14 5l6 6-9 9H8z" fill="ACCENT" fill-opacity="0.25"/><path d="M9 10l6 6M7 20h13"/>)"},
        {"plot",
         R"(<path d="M4 3v17h17"/><path d="M6 17c3 0 3-10 6-10s3 7 5 7 2-4 4-6" stroke="ACCENT" stroke-width="2"/>)"},
        {"measure",
         R"(<path d="M3 16L16 3l5 5L8 21z" fill="ACCENT" fill-opacity="0.25"/><path d="M7 12l2 2M10 9l3 3M13 6l2 2"/>)"},
        {"hinge",
         R"(<path d="M3 17L12 12M21 17L12 12" stroke-width="3"/><circle cx="12" cy="11" r="4.5" fill="INK" fill-opacity="0.15"/><circle cx="12" cy="11" r="1.5" fill="ACCENT" stroke="ACCENT"/>)"},
        {"motor",
         R"(<circle cx="12" cy="12" r="3" fill="ACCENT" stroke="ACCENT"/><path d="M19 14a7.5 7.5 0 1 1 0-4" stroke="#FFB347" stroke-width="2"/><path d="M22 6l-2.6 5.4-4.6-3.2z" fill="#FFB347" stroke="none"/>)"},
        {"weld",
         R"(<path d="M2 15h11M11 9h11" stroke-width="4" stroke-opacity="0.5"/><rect x="8.5" y="8.5" width="7" height="7" fill="ACCENT"/>)"},
        {"spring",
         R"(<path d="M2 12h3l1.5-5 3 10 3-10 3 10 1.5-5h3" stroke="#FFB347" stroke-width="2"/>)"},
        {"cable",
         R"(<path d="M4 5c2 12 14 14 16 14"/><circle cx="4" cy="5" r="2.2" fill="ACCENT"/><circle cx="20" cy="19" r="2.2" fill="ACCENT"/>)"},
        {"winch",
         R"(<circle cx="8" cy="8" r="5.5" stroke="#FFB347"/><circle cx="8" cy="8" r="1.5" fill="INK"/><path d="M13.5 8v9"/><rect x="10.5" y="17" width="6" height="5" fill="ACCENT" fill-opacity="0.5"/>)"},
        {"slider",
         R"(<path d="M2 14h20M3 10v8M21 10v8"/><rect x="7" y="8" width="8" height="8" fill="ACCENT"/>)"},
        {"axle",
         R"(<circle cx="12" cy="16" r="6" fill="ACCENT" fill-opacity="0.25"/><circle cx="12" cy="16" r="1.5" fill="INK"/><path d="M4 3h16M12 3l-2 2 4 2-4 2 4 2-2 2" stroke="#FFB347"/>)"},
        {"pulley",
         R"(<circle cx="12" cy="7" r="4.5"/><path d="M7.5 7v11M16.5 7v7"/><rect x="5" y="17" width="5" height="5" fill="ACCENT"/><rect x="14" y="13" width="5" height="5" fill="ACCENT"/>)"},
        {"gear",
         R"(<circle cx="12" cy="12" r="5.5" fill="ACCENT" fill-opacity="0.3"/><circle cx="12" cy="12" r="1.6" fill="INK"/><path d="M12 2.5v4M12 17.5v4M2.5 12h4M17.5 12h4M5.3 5.3l2.8 2.8M15.9 15.9l2.8 2.8M5.3 18.7l2.8-2.8M15.9 8.1l2.8-2.8" stroke-width="2.6"/>)"},
        {"thruster",
         R"(<path d="M9 3h6l2 9H7z" fill="INK" fill-opacity="0.2"/><path d="M8.5 13.5L12 22l3.500-8.500z" fill="#FFB347" stroke="#FF5E57"/>)"},
        {"wind",
         R"(<path d="M2 9h11a3 3 0 1 0-3-3M2 13h16a3 3 0 1 1-3 3M2 17h8a2.300 2.300 0 1 1-2.300 2.300" stroke="ACCENT"/>)"},
        {"gravity",
         R"(<rect x="3" y="3" width="18" height="18" stroke-dasharray="3 2"/><path d="M12 18V7M8 11l4-4.500 4 4.500" stroke="ACCENT" stroke-width="2.200"/>)"},
        {"conveyor",
         R"(<rect x="2" y="10" width="20" height="8" rx="4"/><circle cx="6" cy="14" r="1.500" fill="INK"/><circle cx="18" cy="14" r="1.500" fill="INK"/><path d="M7 5h9M13 2l3 3-3 3" stroke="#FFB347"/>)"},
        {"liquid",
         R"(<path d="M12 3c4 5 6 8 6 11a6 6 0 0 1-12 0c0-3 2-6 6-11z" fill="ACCENT" fill-opacity="0.45" stroke="ACCENT"/>)"},
        {"level-ground",
         R"(<path d="M2 20V11l5-2 5 3 5-4 5 3v9z" fill="ACCENT" fill-opacity="0.3"/>)"},
        {"level-spawn",
         R"(<circle cx="12" cy="13" r="6" fill="#7CE0A3" fill-opacity="0.4" stroke="#7CE0A3"/><path d="M12 7V2M9 4l3-2 3 2"/>)"},
        {"level-exit",
         R"(<circle cx="12" cy="12" r="8" stroke="#FFB347"/><circle cx="12" cy="12" r="3" fill="#FFB347" stroke="none"/>)"},
        {"level-bounds",
         R"(<path d="M3 8V4h5M16 4h5v4M21 16v4h-5M8 20H3v-4"/><circle cx="12" cy="12" r="3" stroke="ACCENT"/>)"},
        {"level-hint",
         R"(<path d="M3 5h18v11h-9l-4 4v-4H3z"/><path d="M7 9h10M7 12h6" stroke="ACCENT"/>)"},
        {"level-checkpoint",
         R"(<path d="M6 3v18"/><path d="M6 4h12l-4 4 4 4H6z" fill="#7CE0A3" fill-opacity="0.4" stroke="#7CE0A3"/>)"},
        {"level-pickup",
         R"(<path d="M12 3l6 9-6 9-6-9z" fill="#FFB347" fill-opacity="0.4" stroke="#FFB347"/><path d="M6 12h12" stroke-opacity="0.6"/>)"},
        {"level-gravity",
         R"(<rect x="3" y="3" width="18" height="18" rx="2" stroke-dasharray="3 2"/><path d="M12 18V7M8 11l4-4 4 4" stroke="ACCENT"/>)"},
        {"level-wind",
         R"(<path d="M3 9h11a3 3 0 1 0-3-3M3 13h15a3 3 0 1 1-3 3M3 17h7" stroke="ACCENT"/>)"},
        {"level-liquid",
         R"(<path d="M3 9c3-3 6 3 9 0s6 3 9 0v11H3z" fill="ACCENT" fill-opacity="0.35"/>)"},
        {"level-deadly",
         R"(<rect x="3" y="3" width="18" height="18" rx="2" stroke="#E0457B" stroke-dasharray="3 2"/><path d="M8 8l8 8M16 8l-8 8" stroke="#E0457B"/>)"},
        {"level-switch",
         R"(<path d="M3 19h18M6 19l2-5h8l2 5" fill="ACCENT" fill-opacity="0.3"/><path d="M12 4v6M9 7l3 3 3-3" stroke="ACCENT"/>)"},
        {"level-mover",
         R"(<rect x="3" y="14" width="8" height="6" fill="ACCENT" fill-opacity="0.3"/><path d="M12 12l8-8M14 4h6v6" stroke="ACCENT"/>)"},
        {"level-monster",
         R"(<path d="M3 19c0-9 4-13 9-13s9 4 9 13z" fill="#E0457B" fill-opacity="0.35" stroke="#E0457B"/><circle cx="9" cy="13" r="1.4" fill="INK"/><circle cx="15" cy="13" r="1.4" fill="INK"/>)"},
        {"level-rock",
         R"(<path d="M8 14l4-5 5 2 1 6-5 4-5-2z" fill="INK" fill-opacity="0.2"/><path d="M7 3v4M12 2v4M17 3v4" stroke="ACCENT"/>)"},
        {"level-hazard",
         R"(<path d="M2 20L6 8l3 12 3-12 3 12 3-12 4 12z" fill="#E0457B" fill-opacity="0.35" stroke="#E0457B"/>)"},
        {"protractor",
         R"(<path d="M3 19h18a9 9 0 0 0-18 0z" fill="ACCENT" fill-opacity="0.25"/><path d="M12 19L17.5 7.5M12 13v-3M7 15l-2-1.2"/>)"},
        {"tracer",
         R"(<path d="M3 18c4-12 8-14 11-6" stroke="#FFB347" stroke-dasharray="2.4 2.4"/><circle cx="17" cy="15" r="4" fill="ACCENT" fill-opacity="0.4"/><circle cx="17" cy="15" r="1.2" fill="INK" stroke="none"/>)"},
        {"gauge",
         R"(<circle cx="12" cy="12" r="8.5" fill="ACCENT" fill-opacity="0.2"/><path d="M12 12l5-5" stroke="#FF5E57" stroke-width="2.2"/><path d="M5.8 15.5l1.6-.9M6.5 8l1.4 1M12 5.2v1.8M18.2 15.5l-1.6-.9"/>)"},
        {"gun",
         R"(<path d="M3 9h9l3 2v2l-3 2H3z" fill="ACCENT" fill-opacity="0.3"/><path d="M5 15l-1 5h4l1-5"/><path d="M17 12h5" stroke="#FF5E57" stroke-dasharray="2 1.6"/>)"},
        {"group",
         R"(<rect x="3" y="3" width="18" height="18" stroke-dasharray="3 3"/><rect x="6.5" y="6.5" width="6" height="6" fill="ACCENT" fill-opacity="0.5"/><circle cx="15" cy="15" r="3" fill="ACCENT" fill-opacity="0.5"/>)"},
        {"field", R"(<path d="M3 7h13l-3-3M3 12h16l-3-3M3 17h11l-3-3" stroke="ACCENT"/>)"},
        {"eye",
         R"(<path d="M2 12c5-8 15-8 20 0-5 8-15 8-20 0z"/><circle cx="12" cy="12" r="3.2" fill="INK"/>)"},
        {"hidden",
         R"(<path d="M2 10c5 7 15 7 20 0M5 13l-2 3M12 15.500v3.500M19 13l2 3" stroke-opacity="0.6"/>)"},
        {"lock",
         R"(<rect x="5" y="11" width="14" height="10" rx="1.500" fill="ACCENT" fill-opacity="0.7"/><path d="M8 11V8a4 4 0 0 1 8 0v3"/>)"},
        {"unlock",
         R"(<rect x="5" y="11" width="14" height="10" rx="1.500" stroke-opacity="0.7"/><path d="M8 11V7a4 4 0 0 1 7-2.500" stroke-opacity="0.45"/>)"},
        {"revert", R"(<path d="M6 4v6h6"/><path d="M6.5 10A7 7 0 1 1 6 15"/>)"},
    }};

constexpr std::string_view programSvg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">)"
    R"(<rect x="2" y="2" width="60" height="60" rx="14" fill="#0B1026"/>)"
    R"(<path d="M14 44L32 14l18 30z" fill="#1F3A5F" stroke="#6FA8DC" stroke-width="3"/>)"
    R"(<path d="M32 14v18M14 44l18-12 18 12" stroke="#6FA8DC" stroke-width="2" fill="none"/>)"
    R"(<circle cx="32" cy="14" r="6" fill="#FFB347"/><circle cx="14" cy="44" r="6" fill="#E8F4FF"/>)"
    R"(<circle cx="50" cy="44" r="6" fill="#E8F4FF"/><circle cx="32" cy="32" r="5" fill="#FFB347"/></svg>)";

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
        text.replace(at, what.size(), with);
    return text;
}

}  // namespace

wxBitmapBundle icon(std::string_view name, int size) {
    const bool dark = wxSystemSettings::GetAppearance().IsUsingDarkBackground();
    for (const auto& [key, shapes] : icons) {
        if (key != name) continue;
        std::string svg =
            R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><g fill="none" stroke="INK" )"
            R"(stroke-width="1.7" stroke-linecap="round" stroke-linejoin="round">)";
        svg += shapes;
        svg += "</g></svg>";
        svg = replaced(svg, "INK", dark ? "#E8F4FF" : "#1F3A5F");
        svg = replaced(svg, "ACCENT", dark ? "#6FA8DC" : "#2F6FB0");
        return wxBitmapBundle::FromSVG(svg.c_str(), wxSize(size, size));
    }
    return {};
}

wxBitmapBundle programIcon() {
    return wxBitmapBundle::FromSVG(std::string(programSvg).c_str(), wxSize(64, 64));
}

}  // namespace sulfurchamber
