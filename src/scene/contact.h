// Does an emitter touch glass, or nearly? Rays start off surfaces by what rounding may have moved them, so light that
// leaves an emitter so close to glass would start within it, as if there were no air between: without refraction, and
// with light held back by total reflection that gets out in fact. Found at commit; such an emitter is set back until
// rays have the room that they need, some micrometres in a room (scene/prepare_contacts.cpp).
#pragma once
#include <memory>
#include <set>
#include <vector>

#include "base/monitor.h"
#include "emitter/emitter.h"
#include "scene/media.h"

namespace ups {

// What a search depends on: as long as it is the same, so is what was found.
struct ContactPart {
  // solid: of glass; sheet: lets light through; both emit nothing.
  enum Role : uint8_t { none_emitted, emits, emits_both_sides, opening, rays, solid, sheet };
  Role role;
  uint32_t number;  // of the instance or luminaire
  Affine to_scene;
  std::shared_ptr<const void> shape;  // mesh or profile
  bool operator==(const ContactPart&) const = default;
};

// A surface that is searched: what its rays find depends on where it has holes, too, and, by whether a mesh is there once
// or several times, on all that are searched with it.
struct SearchedSurface {
  ContactPart what;
  SurfaceTexturing texturing;
  bool operator==(const SearchedSurface&) const = default;
};

struct Contact {
  std::vector<ContactPart> between;  // the emitter, then what its box meets
  uint32_t touched = none;           // number of the instance that it is closest to; none: it touches nothing
  Vec3d shift;                       // that sets it back
  bool squeezed = false;             // it touches something on several sides: nothing helps
  bool blocked = false;              // something lies where it would be set back to
  bool shallow = false;              // it is as close, but within the glass: it stays there
  bool is_to_move() const { return touched != none && !squeezed && !shallow; }  // where it has room
  bool is_moved() const { return is_to_move() && !blocked; }
};

inline constexpr double shallow_m = 1e-4;  // what is meant to be in glass is deeper

// Where light leaves: n is on the side to which it does.
struct EmittingPoint {
  Vec3 p, n;
  float error;
};
std::vector<EmittingPoint> emitting_points(const Emitter& emitter, bool both_sides);

// Instances that let light through, of which any box may be asked.
class TouchableParts {
 public:
  struct Part {
    ContactPart what;
    Box box;
    Raytracer::Instance instance;
  };
  struct Room {
    double rounding;  // of a place in the scene; what is closer may be on either side
    double shadow;    // by which shadow rays are shortened
    double most;      // that an emitter needs
  };
  TouchableParts(std::vector<Part> parts, const Room& room);  // by number, ascending

  bool empty() const { return parts_.empty(); }
  // Appends those whose boxes an emitter's comes near.
  void near(Box box, std::vector<ContactPart>& out) const;
  // Those that one of `contacts` may touch, and all others of the same meshes, so that rounding is as it will be in the
  // scene. The lists are those of the scene.
  template <class Contacts>
  std::vector<SearchedSurface> choose(const Contacts& contacts, const std::vector<SurfaceTexturing>& texturing) {
    std::set<std::shared_ptr<const void>> wanted;
    for (const auto& [key, c] : contacts)
      for (size_t i = 1; i < c.between.size(); ++i) wanted.insert(c.between[i].shape);
    return choose_of(wanted, texturing);
  }
  // For rays against those that were chosen.
  void trace(const std::vector<std::shared_ptr<const Mesh>>& meshes, const std::vector<SurfaceTexturing>& texturing,
             ThreadPool& pool, Monitor& monitor);
  void forget_trace() { raytracer_.reset(), traced_.clear(); }
  void search(const std::vector<EmittingPoint>& points, Contact& out) const;
  // Is something else between an emitter that is set back and where it was?
  bool is_blocked(const std::vector<EmittingPoint>& points, const Contact& contact, const Raytracer& all,
                  const std::vector<Raytracer::Instance>& instances) const;

 private:
  std::vector<SearchedSurface> choose_of(const std::set<std::shared_ptr<const void>>& meshes,
                                         const std::vector<SurfaceTexturing>& texturing);
  const Part* part_of(uint32_t number) const;
  bool faces(const Part& part, const EmittingPoint& from, const SurfacePoint& surface, double gap) const;

  std::vector<Part> parts_;
  std::vector<std::pair<double, size_t>> by_x_;  // where boxes begin
  double widest_ = 0;                            // along x
  std::vector<Raytracer::Instance> traced_;
  std::unique_ptr<const Raytracer> raytracer_;
  double rounding_, shadow_, reach_;
};

}  // namespace ups
