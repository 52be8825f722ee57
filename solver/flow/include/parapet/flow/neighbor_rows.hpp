/// Cell-sorted neighbour rows, reused while no pair can have come closer than the skin allows.
#pragma once

#include <cstdint>
#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/flow/geometry.hpp"
#include "parapet/flow/wall_layout.hpp"

namespace parapet::solver {

/// Who is near whom. A flow keeps its own; on their own they serve to study the neighbour search.
class NeighborRows {
 public:
  /// Solids and walls are kept by reference.
  /// @param reach kernel support 2h [m]
  /// @param skin extra reach of the rows [m]
  /// @param periodic_length along x from 0 [m]; 0 when not periodic
  NeighborRows(const Solids& solids, const WallPoints& walls, double reach, double skin,
               double periodic_length);

  /// True when a pair outside the rows may have come within the reach.
  bool outdated(const Fluid& fluid) const;
  /// Sorts the fluid by cell and builds the rows anew.
  void build(Fluid& fluid, int threads);
  /// The rows are outdated from now on.
  void invalidate() { valid_ = false; }

  RowView view() const;  ///< valid until the next build
  std::int64_t fluid_slots() const { return static_cast<std::int64_t>(index_.size()); }
  bool touches_wall(int i) const {  ///< particle i has wall points in its row
    return end_[static_cast<std::size_t>(i)] > wall_begin_[static_cast<std::size_t>(i)];
  }
  /// Faces near a place: a superset of those within reach + skin.
  const std::vector<int>& faces_near(Vec2 p) const;

 private:
  struct Grid {  // uniform cells, column by column
    double x0 = 0.0, z0 = 0.0, cell_x = 1.0, cell_z = 1.0;
    int nx = 1, nz = 1;
    int column(double x) const;
    int row(double z) const;
    std::size_t cell(int ix, int iz) const {
      return static_cast<std::size_t>(ix) * static_cast<std::size_t>(nz) +
             static_cast<std::size_t>(iz);
    }
  };
  struct RowBuffer {  // one block's rows before they are joined
    std::vector<std::int32_t> index, fluid_count, wall_count;
  };

  void prepare_walls();
  // Whether a particle from here may reach a wall before it has moved half a cell.
  bool wall_may_be_reached(Vec2 p) const;
  void sort(Fluid& fluid);
  void fill_block(const Fluid& fluid, int begin, int end, RowBuffer& buffer) const;
  void add_fluid_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                           std::vector<std::int32_t>& out) const;
  void add_wall_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                          std::vector<std::int32_t>& out) const;
  void join(const std::vector<RowBuffer>& buffers, int n);
  void transpose_wall_rows(int n);

  const Solids& solids_;
  const WallPoints& walls_;
  double reach_, skin_, periodic_length_;
  bool valid_ = false;

  Grid wall_grid_;  // over the walls
  std::vector<std::int32_t> wall_start_, wall_sorted_;
  std::vector<char> cell_near_wall_;          // per cell of wall_grid_
  std::vector<std::vector<int>> cell_faces_;  // per cell of wall_grid_
  std::vector<int> no_faces_;

  Grid grid_;  // over the fluid, renewed at each build
  std::vector<std::int32_t> start_, order_, cell_of_, next_, occupied_;
  std::vector<char> near_wall_;            // per cell
  std::vector<double> built_x_, built_z_;  // positions at the build

  std::vector<std::int32_t> begin_, wall_begin_, end_, index_;
  std::vector<std::int32_t> point_begin_, point_end_, point_index_, active_, point_count_;
  std::vector<RowBuffer> buffers_;
  mutable std::vector<double> motion_;  // scratch of outdated()
};

}  // namespace parapet::solver
