// How much a source of light troubles an eye by where it stands: Guth's position index, for glare ratings. The standard
// library only.
//
// The eye looks along +R; T is to its right, H up: R forward, T lateral, H above the line of sight, of any unit.
#pragma once

namespace photometry {

enum class PositionIndex {
  table,  // of CIE 117:1995 (table 4.1), bilinear between its cells: for UGR
  guth    // Guth's index in the closed form of Levin, up to 12 % from the table
};

// >= 1; < 0: not a source of glare: behind the eye, or above the line of sight beyond the table (T/R > 3, H/R > 1.9 and
// its empty cells), which CIE 117 ignores. The table is of sources above the line of sight; those below have Einhorn's
// index for both kinds, as Radiance's evalglare has it. The closed form is capped at 16, the table's last value.
double position_index(PositionIndex kind, double right, double up, double forward);

// A cell of the table: row T/R = row / 10, row <= 30; column H/R = column / 10, column <= 19. < 0: an empty one.
double position_index_cell(int row, int column);

}  // namespace photometry
