// A map for people: illuminance over a plane, or luminance of an image, in false colours with isolines, on the plan of
// the room. Plain data in, a drawing out; knows nothing of scenes, results and files: map_data.h gets it from those.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "report/drawing.h"

namespace ups::report {

// In the map's plane, x to the right and y upwards: metres, or pixels of an image.
struct Place {
  double x, y;
};

struct MapValue {
  Place at;
  double value;             // < 0 or not finite: not known
  double error_bound = -1;  // 95 %, in the value's unit; < 0: not known
};

struct MapLine {
  std::vector<Place> points;
  bool cut;  // by the map's plane, as walls are: drawn strongly; else seen beneath it, as furniture is
};

struct MapLuminaire {
  Place centre;
  std::vector<Place> outline;  // of its opening, closed; empty: a point, drawn as a symbol alone
};

struct MapObserver {
  Place at, looks_along;  // a direction
  std::string name;
};

struct MapData {
  std::string title;     // of the set of meters, or the camera
  std::string quantity;  // "Illuminance"
  std::string unit;      // "lx"
  std::string summary;   // below the title: mean, minimum, uniformity and their bounds
  bool is_image = false;  // in pixels: without a bar of metres, points and numbers
  bool of_camera = false;  // an image whose pixels are noisy
  // A grid where columns > 0: columns run fastest, row 0 is the lowest. Else points anywhere; where they lie on a
  // lattice with gaps, as those of EN 12464-1 in an L-shaped room do, that is found and each has its cell of it.
  uint32_t columns = 0, rows = 0;
  std::vector<MapValue> values;
  std::vector<std::vector<Place>> area;  // closed, even-odd: no colour outside; empty: all of the cells
  std::vector<MapLine> room;
  std::vector<MapLuminaire> luminaires;
  std::vector<MapObserver> observers;
  double north_x = 0, north_y = 0;  // direction of an arrow; both 0: none
  std::string north = "N";          // at the arrow's tip
};

enum class MapScale { linear, logarithmic };
enum class MapColours { viridis, cividis, grey };  // each rises in lightness from low to high

struct MapStyle {
  MapScale scale = MapScale::linear;
  MapColours colours = MapColours::viridis;
  double low = 0, high = 0;   // of the scale; both 0: from the values
  double threshold = 0;       // > 0: the cells that meet it, do not, and those whose bound crosses it, in three colours
  // The same of images of luminance, cd/m2, where both kinds are drawn.
  double luminance_low = 0, luminance_high = 0, luminance_threshold = 0;
  bool isolines = true, numbers = true;
  bool cells = false;         // each cell in one colour, without what lies between the values
  double width = 680;         // of the drawing, units; 680 units are 180 mm
  double most_height = 560;  // half a page of A4
  bool operator==(const MapStyle&) const = default;
};

// Whether a scale can have these ends: colours and numbers along it must differ.
inline bool is_range(double low, double high) {
  return (low == 0 || low >= 1e-12) && high >= 1e-9 && high <= 1e12 && high - low >= 1e-6 * high;
}

// Of a drawing no wider than style.width and no higher than style.most_height.
Drawing map_drawing(const MapData& data, const MapStyle& style);
// The same in a title and a sentence or two, for those who cannot see it.
Words map_words(const MapData& data, const MapStyle& style);
std::string map_description(const MapData& data, const MapStyle& style);

enum class Verdict { met, not_met, not_sure, unknown };
Verdict verdict_of(const MapValue& value, double threshold);

}  // namespace ups::report
