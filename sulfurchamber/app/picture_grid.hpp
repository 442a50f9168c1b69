// A window of pictures with names below headings: templates, recent files, examples.
#pragma once

#include <wx/bitmap.h>
#include <wx/scrolwin.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../view/picture_grid_layout.hpp"
#include "../view/thumbnails.hpp"

namespace sulfurchamber {

class PictureGrid final : public wxScrolledWindow {
public:
    /// One picture: that of a scene file.
    struct Item {
        std::string group;  ///< its heading; empty: none
        std::string name;   ///< that tells it from others
        std::string label;  ///< what stands below it; empty: the name
        std::string help;   ///< tooltip
        std::filesystem::path file;
        bool marked = false;  ///< with a dot: it wants attention
    };

    /// `thumbnails` must outlive the window.
    PictureGrid(wxWindow* parent, Thumbnails& thumbnails);

    void show(std::vector<Item> items);
    const std::vector<Item>& items() const { return items_; }
    /// What is drawn instead of pictures where there are none.
    void setEmptyText(const wxString& text) { emptyText_ = text; }
    /// Pictures about so wide (logical pixels), with names of up to so many lines; 88 and 1.
    void setTiles(int pictureWidth, int nameLines);
    std::optional<std::size_t> chosen() const { return chosen_; }
    void choose(std::optional<std::size_t> item);
    /// Takes pictures that have come. Cheap; may be called often.
    void refreshPictures();
    /// Where an item is on the screen; for scripts.
    wxRect onScreen(std::size_t item) const;

    std::function<void(std::size_t)> onChosen;     ///< clicked, or reached by keys
    std::function<void(std::size_t)> onActivated;  ///< clicked twice, or Enter
    /// Dragged out of the window and let go, at a place of the screen.
    std::function<void(std::size_t, wxPoint)> onDragged;

private:
    void layOut();
    void paint(wxPaintEvent& event);
    void paintCell(wxDC& dc, std::size_t item);
    void paintName(wxDC& dc, const Item& item, const GridRect& cell);
    int labelHeight() const;
    void press(wxMouseEvent& event);
    void release(wxMouseEvent& event);
    void hover(wxMouseEvent& event);
    void key(wxKeyEvent& event);
    void showItem(std::size_t item);
    const wxBitmap* bitmapOf(const std::filesystem::path& file, const wxSize& size);

    Thumbnails& thumbnails_;
    std::vector<Item> items_;
    PictureGridLayout layout_;
    wxString emptyText_;
    int pictureWidth_ = 88;  // logical pixels
    int nameLines_ = 1;
    struct Shown {
        const atlax::Image* picture = nullptr;
        wxBitmap bitmap;
    };
    std::map<std::string, Shown> bitmaps_;
    std::uint64_t revision_ = 0;
    std::optional<std::size_t> chosen_;
    std::optional<std::size_t> hovered_;
    std::optional<wxPoint> pressed_;
    int laidOutWidth_ = 0;
};

/// A picture of atlax as one of wxWidgets, scaled.
wxBitmap toBitmap(const atlax::Image& picture, const wxSize& size);

}  // namespace sulfurchamber
