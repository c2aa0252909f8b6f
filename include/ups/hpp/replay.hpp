// UPS for C++17: a sample traced again, ups_replay.h. See ups.hpp.
#ifndef UPS_HPP_REPLAY_HPP
#define UPS_HPP_REPLAY_HPP

#include "base.hpp"

namespace ups {
inline namespace v0_1 {

// What Scene::replay finds; immutable, any thread.
class Path : public Handle<ups_path> {
 public:
  using Handle::Handle;
  ups_path_info get_info() const { return detail::sized<ups_path_info>(ups_path_get_info, get()); }
  std::vector<ups_path_vertex> read_vertices() const {
    return detail::list<ups_path_vertex>(ups_path_read_vertices, get());
  }
  std::vector<ups_path_contribution> read_contributions() const {
    return detail::list<ups_path_contribution>(ups_path_read_contributions, get());
  }
  std::string get_text() const { return detail::text(ups_path_get_text, get()); }
};

}  // namespace v0_1
}  // namespace ups

#endif
