// See builder.h: emitters that touch glass are set back, so that rays find the air between (scene/contact.h).
#include <algorithm>

#include "base/parallel.h"
#include "base/text.h"
#include "emitter/area.h"
#include "emitter/profile.h"
#include "scene/builder.h"
#include "scene/footing.h"
#include "scene/length_text.h"
#include "scene/traced_box.h"

namespace ups {
namespace {

Box around(const Vec3d& p, const Vec3d& reach) { return {p - reach, p + reach}; }

}  // namespace

double Builder::rounding_of_places() const { return 4 * 0x1p-24 * out_->extent; }

// No less than what an opening's error has beyond its own rounding where it lies on a surface, see footing.h.
double Builder::contact_error() const { return 3 * 0x1p-20 * double(out_->radius); }
double Builder::contact_reach() const { return 16 * contact_error() + 2 * rounding_of_places(); }

TouchableParts Builder::touchable_parts() const {
  std::vector<TouchableParts::Part> parts;
  for (const Raytracer::Instance& i : out_->instances) {
    const Material& m = out_->materials[i.material];
    const bool solid = m.model == MaterialModel::glass && m.ior != 1,
               sheet = m.model == MaterialModel::glazing || m.model == MaterialModel::diffuser;
    if ((!solid && !sheet) || emission(i) != ContactPart::none_emitted) continue;
    const auto& mesh = out_->meshes[i.mesh];
    parts.push_back({{solid ? ContactPart::solid : ContactPart::sheet, i.number, i.to_scene, mesh},
                     traced_box(*out_, i), i});
  }
  // A shadow ray is shortened by what its length and origin round to, see segment_free (transport/encounter.h).
  return {std::move(parts), {rounding_of_places(), 0x1p-18 * double(out_->radius), contact_reach()}};
}

ContactPart::Role Builder::emission(const Raytracer::Instance& i) const {
  const MaterialDescription& m = in_.materials().at(out_->material_numbers[i.material]);
  if (is_black(to_rgb(m.luminance_cd_m2))) return ContactPart::none_emitted;
  return m.emits_both_sides == 1 ? ContactPart::emits_both_sides : ContactPart::emits;
}

// Of those that are near something, by their sources; nothing is searched yet.
std::map<Builder::SourceKey, Contact> Builder::possible_contacts(const TouchableParts& touchable) const {
  std::map<SourceKey, Contact> contacts;
  const auto add = [&](const SourceKey& key, const ContactPart& emitter, const Box& box) {
    Contact contact;
    contact.between.push_back(emitter);
    touchable.near(box, contact.between);
    if (contact.between.size() > 1) contacts.emplace(key, std::move(contact));
  };
  for (const Raytracer::Instance& i : out_->instances) {
    const ContactPart::Role role = emission(i);
    if (role == ContactPart::none_emitted) continue;
    const auto& mesh = out_->meshes[i.mesh];
    add({UPS_SOURCE_INSTANCE, i.number}, {role, i.number, i.to_scene, mesh},
        traced_box(*out_, i));
  }
  in_.sources().each([&](uint32_t id, const SourceDescription& source) {
    const auto* l = std::get_if<LuminaireDescription>(&source.kind);
    if (!l || !l->use_opening) return;
    const bool rays = !l->profile->rays.empty();
    if (!rays && !LuminousBody::has_area(l->profile->opening)) return;
    add({UPS_SOURCE_LUMINAIRE, id},
        {rays ? ContactPart::rays : ContactPart::opening, id, to_scene(l->to_world), l->profile}, emission_box(*l));
  });
  return contacts;
}

Box Builder::emission_box(const LuminaireDescription& l) const {
  const Vec3d p = l.to_world.column(3) - out_->origin;
  if (l.profile->rays.empty()) {
    const float* size = l.profile->opening.size_m;
    const double reach = 0.5 * std::hypot(double(size[0]), double(size[1]), double(size[2]));
    return around(p, {reach, reach, reach});
  }
  double reach = 0;
  for (const photometry::Ray& r : l.profile->rays)
    reach = std::max(reach, std::hypot(double(r.p_m[0]), double(r.p_m[1]), double(r.p_m[2])));
  return around(p, {reach, reach, reach});
}

std::vector<EmittingPoint> Builder::points_of(const Contact& contact) const {
  const ContactPart& what = contact.between[0];
  if (what.role == ContactPart::emits || what.role == ContactPart::emits_both_sides) {
    const bool both_sides = what.role == ContactPart::emits_both_sides;
    const auto& mesh = *static_cast<const Mesh*>(what.shape.get());
    return emitting_points(AreaEmitter(emitting_triangles(mesh, what.to_scene), Rgb(1), false, 0), both_sides);
  }
  const auto profile = std::static_pointer_cast<const photometry::Photometry>(what.shape);
  const Frame frame = Axes(what.to_scene).frame();
  const Vec3 p(what.to_scene.column(3));
  if (what.role == ContactPart::rays)
    return emitting_points(RayEmitter(std::make_shared<RaySet>(profile), frame, p, Rgb(1)), false);
  const std::shared_ptr<const photometry::Distribution> distribution(profile, &profile->distribution);
  const float error = 2 * free_error(p) + float(contact_error());
  return emitting_points(ProfileOpeningEmitter(distribution, frame, p, profile->opening, Rgb(1), error), false);
}

TouchableParts Builder::find_contacts() {
  TouchableParts touchable = touchable_parts();
  if (!touchable.empty()) search_contacts(touchable);
  // One that is gone has left its emitter where that was set back to.
  if (!earlier_) return touchable;
  for (const auto& [key, before] : earlier_->contacts) {
    const auto now = out_->contacts.find(key);
    contacts_differ_ |= before.is_to_move() && (now == out_->contacts.end() || !now->second.is_to_move());
  }
  return touchable;
}

void Builder::search_contacts(TouchableParts& touchable) {
  out_->contacts = possible_contacts(touchable);
  out_->searched_surfaces = touchable.choose(out_->contacts, out_->texturing);
  const bool may_share = earlier_ && earlier_->extent == out_->extent && earlier_->radius == out_->radius &&
                         earlier_->searched_surfaces == out_->searched_surfaces;
  std::vector<Contact*> unknown;
  for (auto& [key, contact] : out_->contacts) {
    const auto known = may_share ? earlier_->contacts.find(key) : out_->contacts.end();
    if (may_share && known != earlier_->contacts.end() && known->second.between == contact.between)
      contact = known->second;
    else
      unknown.push_back(&contact);
  }
  if (unknown.empty()) return;
  monitor_.begin_part(0.2f);
  touchable.trace(out_->meshes, out_->texturing, threads_, monitor_);
  parallel_for(threads_, unknown.size(), [&](size_t i) {
    monitor_.check();
    touchable.search(points_of(*unknown[i]), *unknown[i]);
  });
  touchable.forget_trace();  // what is built next has the whole of the memory's limit, too
  contacts_differ_ = std::any_of(unknown.begin(), unknown.end(), [](const Contact* c) { return c->is_to_move(); });
}

// Where they are without contact, or where that has set them back to.
void Builder::set_back_emitters() {
  if (out_->contacts.empty()) return;
  for (Raytracer::Instance& i : out_->instances) {
    const auto at = out_->contacts.find({UPS_SOURCE_INSTANCE, i.number});
    if (at == out_->contacts.end()) continue;
    const Contact& contact = at->second;
    i.to_scene = contact.between[0].to_scene;
    if (!contact.is_moved()) continue;
    i.to_scene.m[3] += contact.shift.x, i.to_scene.m[7] += contact.shift.y, i.to_scene.m[11] += contact.shift.z;
  }
}

// Whether an emitter has room to be set back is seen once all surfaces are there.
void Builder::trace_surfaces(const TouchableParts& touchable) {
  const auto trace = [&](const Raytracer* earlier) {
    out_->raytracer = std::make_shared<const Raytracer>(out_->meshes, out_->instances, out_->texturing, threads_,
                                                        out_->media.nest || out_->finds_all, earlier, &monitor_);
  };
  for (auto& [key, contact] : out_->contacts) contact.blocked = false;
  set_back_emitters();
  trace(earlier_ ? earlier_->raytracer.get() : nullptr);
  std::vector<Contact*> moved;
  for (auto& [key, contact] : out_->contacts)
    if (contact.is_moved()) moved.push_back(&contact);
  parallel_for(threads_, moved.size(), [&](size_t i) {
    monitor_.check();
    moved[i]->blocked = touchable.is_blocked(points_of(*moved[i]), *moved[i], *out_->raytracer, out_->instances);
  });
  if (std::none_of(moved.begin(), moved.end(), [](const Contact* c) { return c->blocked; })) return;
  set_back_emitters();
  const auto before = out_->raytracer;
  trace(before.get());
}

// Of the source that was begun last; null: it touches nothing.
const Contact* Builder::contact_of_source() {
  const Source& source = out_->sources.back();
  const auto at = out_->contacts.find({source.kind, source.id});
  if (at == out_->contacts.end() || at->second.touched == none) return nullptr;
  touching_.push_back({{source.kind, source.id}, &at->second});
  return &at->second;
}

namespace {

enum class Told { moved, shallow, stuck };

Told what_to_tell(const Contact& c) { return c.is_moved() ? Told::moved : c.shallow ? Told::shallow : Told::stuck; }

std::string contact_text(Told what, uint32_t touched, double shift, double room) {
  const std::string number = "instance " + std::to_string(touched);
  if (what == Told::moved)
    return "on what lets light through (" + number + "), closer than rays resolve: taken to shine into it through " +
           "air, and set back by " + length_text(shift) + "; what is to shine within the glass has to lie deeper in it";
  if (what == Told::shallow)
    return "in glass (" + number + "), less than " + length_text(std::min(room, shallow_m)) + " below its surface: " +
           "light starts within it, where total reflection holds much of it back; move what is to shine through air out of it";
  return "on what lets light through (" + number + "), closer than rays resolve, and with no room to be set back: " +
         "much of the light may be lost; leave a gap of " + length_text(2 * room);
}

}  // namespace

// All of a kind at once, with what one of them touches.
void Builder::warn_of_contacts() {
  struct Group {
    std::vector<uint32_t> ids;
    double shift = 0;
    uint32_t touched = none;
  };
  std::map<std::pair<ups_source_kind, Told>, Group> groups;
  for (const auto& [key, contact] : touching_) {
    Group& group = groups[{key.first, what_to_tell(*contact)}];
    group.ids.push_back(key.second);
    group.shift = std::max(group.shift, length(contact->shift));
    if (group.touched == none) group.touched = contact->touched;
  }
  for (const auto& [key, group] : groups)
    warn(listed(key.first == UPS_SOURCE_INSTANCE ? "instance" : "luminaire", group.ids) + ": " +
         contact_text(key.second, group.touched, group.shift, contact_reach()));
}

}  // namespace ups
