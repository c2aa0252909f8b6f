// The plot of a map, without the page around it. Called by map.cpp.
#pragma once
#include "report/map_colours.h"
#include "report/profile_plot.h"

namespace ups::report {

struct MapView {
  MapBox extent;        // what is shown, in the plane
  Frame frame;          // where, in the drawing
  double scale;         // units a metre, or a pixel of an image
  Point at(const Place& p) const {
    return {frame.left + (p.x - extent.left) * scale, frame.top + (extent.high - p.y) * scale};
  }
  Place place(const Point& p) const {
    return {extent.left + (p.x - frame.left) / scale, extent.high - (p.y - frame.top) / scale};
  }
};

// What is shown: the cells, and of the room around them what is near.
MapBox extent_of(const MapData& data, const MapField& field);

void draw_plot(Drawing& drawing, const MapView& view, const MapData& data, const MapField& field,
               const MapStyle& style, const MapRange& range);

// As precise as the largest value asks for: whole from 100 on.
std::string value_text(double value, double largest);

}  // namespace ups::report
