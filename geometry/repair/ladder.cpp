// SPDX-License-Identifier: GPL-3.0-or-later
// The rungs of the repair of one part, in order.
#include "geometry/repair/ladder.h"

#include "core/error.h"
#include "geometry/half_edges.h"
#include "geometry/join_points.h"
#include "geometry/measure.h"
#include "geometry/repair/clean.h"
#include "geometry/repair/describe.h"
#include "geometry/repair/holes.h"
#include "geometry/repair/membranes.h"
#include "geometry/repair/nearest.h"
#include "geometry/repair/orient.h"
#include "geometry/repair/outward.h"
#include "geometry/repair/place_sheets.h"
#include "geometry/repair/sheets.h"
#include "geometry/repair/stitch.h"
#include "geometry/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

// Of a shell's area, more than this may not look into places with a winding number below zero.
constexpr double most_inverted = 0.02;

bool is_one_sided(const SurfacePart& shell)
{
  bool one_sided = false;
  visit_edges(sorted_half_edges(shell), [&](std::span<const HalfEdge> edge) {
    one_sided |= edge.size() == 2 && edge[0].forward == edge[1].forward;
  });
  return one_sided;
}

class Ladder
{
public:
  Ladder(const SurfacePart& part, const SurfaceReport& before, const RepairSizes& sizes)
      : sizes_(sizes), original_(part), soup_(part)
  {
    report_.before = before;
  }

  LadderResult climb()
  {
    clean();
    close_gaps();
    find_shells();
    turn_shells();
    add_sheets();
    SurfacePart part = assembled();
    report_.after = check_surface(part);
    if (report_.actions.empty() && report_.before.balanced && bounds_a_body(part)) {
      report_.after = report_.before;
      return {original_, std::move(report_)}; // overlaps and the like, which need no change
    }
    if (!bounds_a_body(part))
      wrap(part);
    if (body_changed_) {
      const Move move = surface_move(part, reference_);
      report_.largest_move = without_rounding(std::max(move.largest, gap_));
      report_.mean_move = without_rounding(move.mean);
    }
    return {std::move(part), std::move(report_)};
  }

private:
  double without_rounding(double length) const { return length > 1e-9 * std::sqrt(total_area_) ? length : 0; }

  void did(const std::string& action) { report_.actions.push_back(action); }
  void changed(const std::string& action)
  {
    body_changed_ = true;
    did(action);
  }

  void clean()
  {
    if (const std::size_t joined = report_.before.doubled_points; joined > 0) {
      join_equal_points(soup_);
      did("joined " + count_text(joined, "double point", "double points"));
    }
    if (report_.before.degenerate_faces > 0) {
      with_flat_ = soup_;
      drop_flat_triangles(soup_);
    }
    require(!soup_.triangles.empty(), "none of its triangles has an area; export it again");
    if (const std::size_t doubled = drop_doubled_triangles(soup_); doubled > 0) {
      drop_doubled_triangles(with_flat_);
      did("dropped " + count_text(doubled, "doubled triangle", "doubled triangles"));
    }
  }

  void close_gaps()
  {
    Stitching stitching;
    if (find_topology(soup_).open_edges > 0)
      stitching = stitch(soup_, sizes_.spacing / 2);
    if (report_.before.degenerate_faces > 0) {
      const std::string flat =
          count_text(report_.before.degenerate_faces, "triangle", "triangles") + " without area";
      if (!find_topology(soup_).balanced() && find_topology(with_flat_).balanced()) {
        soup_ = with_flat_; // they hold the surface together
        stitching = {};
        report_.notes.push_back("kept " + flat + ": they change nothing");
      } else {
        did("dropped " + flat);
      }
    }
    total_area_ = surface_area(soup_);
    gap_ = without_rounding(stitching.gap);
    if (stitching.joined + stitching.split > 0) {
      const std::string joined = "joined " + count_text(stitching.joined, "border point", "border points"),
                        split = "split sides at " + count_text(stitching.split, "T-junction", "T-junctions");
      changed((stitching.joined == 0  ? split
               : stitching.split == 0 ? joined
                                      : joined + " and " + split) +
              (gap_ > 0 ? " (gaps of up to " + length_text(gap_) + ")" : ""));
    }
  }

  void find_shells()
  {
    sheets_ = detach_membranes(soup_);
    total_area_ = surface_area(soup_);
    const Winding winding = wind_alike(soup_);
    std::vector<SurfacePart> pieces = split_by(soup_, winding.shell, winding.shells);
    std::vector<Shell> shells(pieces.size());
    std::vector<double> area(pieces.size(), 0), flipped_area(pieces.size(), 0);
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      const int s = winding.shell[t];
      const auto [a, b, c] = soup_.triangles[t];
      const double twice =
          (soup_.points[b] - soup_.points[a]).cross(soup_.points[c] - soup_.points[a]).norm();
      ++shells[s].own;
      shells[s].flipped += winding.flipped[t];
      area[s] += twice;
      flipped_area[s] += winding.flipped[t] ? twice : 0;
    }
    for (std::size_t s = 0; s < shells.size(); ++s) {
      shells[s].surface = std::move(pieces[s]);
      shells[s].trusted = flipped_area[s] < 0.25 * area[s] || flipped_area[s] > 0.75 * area[s];
      sort_shell(std::move(shells[s]));
    }
    if (holes_ > 0)
      changed("filled " + count_text(holes_, "hole", "holes") + " (" + (holes_ > 1 ? "largest " : "") +
              length_text(widest_hole_) + " across)");
    if (large_holes_ > 0)
      report_.notes.push_back("the cap over a hole of " + length_text(widest_hole_) +
                              " is flat and as large as a third of its piece or more: see that it is meant");
  }

  // A closed shell, a shell with holes to fill, or a sheet?
  void sort_shell(Shell shell)
  {
    if (is_one_sided(shell.surface)) {
      report_.notes.push_back("a piece is one-sided like a Moebius strip: it has no inside");
      sheets_.push_back(std::move(shell.surface));
      return;
    }
    const auto holes = find_holes(shell.surface);
    const SurfacePart open = shell.surface;
    double caps = 0, widest = 0;
    for (const auto& hole : holes) {
      widest = std::max(widest, loop_width(open, hole));
      caps += fill_hole(shell.surface, hole);
    }
    if (!encloses_volume(shell.surface) || (!holes.empty() && is_sheet(open, shell.surface))) {
      sheets_.push_back(open);
      return;
    }
    holes_ += holes.size();
    widest_hole_ = std::max(widest_hole_, widest);
    large_holes_ += caps > surface_area(open) / 3;
    append(reference_, open);
    closed_.push_back(std::move(shell));
  }

  void turn_shells()
  {
    const Nesting nesting = turn_outward(closed_);
    std::size_t flipped = 0, all = 0;
    for (const Shell& shell : closed_) {
      flipped += shell.turned ? shell.own - shell.flipped : shell.flipped;
      all += shell.own;
    }
    if (flipped > 0)
      did("flipped " +
          (flipped == all ? "all " + std::to_string(all)
                          : std::to_string(flipped) + " of " + std::to_string(all)) +
          " triangles");
    const auto note = [&](std::size_t count, const std::string& one, const std::string& many) {
      if (count > 0)
        report_.notes.push_back(count_text(count, one, many));
    };
    note(nesting.cavities, "piece lies inside another and looks inwards: it is the wall of a cavity",
         "pieces lie inside others and look inwards: they are walls of cavities");
    note(nesting.guessed, "of them was wound so mixed that this is a guess",
         "of them were wound so mixed that this is a guess");
    note(nesting.nested,
         "piece lies inside another and looks outwards: it is taken as filled and changes nothing",
         "pieces lie inside others and look outwards: they are taken as filled and change nothing");
    if (nesting.overlapping > 0)
      report_.notes.push_back(
          "pieces overlap: they are taken as one body (the volume given here counts what they share "
          "twice)");
  }

  void add_sheets()
  {
    SurfacePart body{soup_.name, {}, {}};
    for (const Shell& shell : closed_)
      append(body, shell.surface);
    SheetWork work = place_sheets(std::move(sheets_), body, total_area_, sizes_);
    for (const std::string& action : work.actions)
      action.starts_with("dropped") ? did(action) : changed(action);
    append(reference_, work.used);
    for (SurfacePart& solid : work.solids) {
      Shell& shell = closed_.emplace_back();
      shell.surface = std::move(solid);
    }
    require(!closed_.empty(), "nothing is left of it that bounds a body; model it as a solid");
  }

  SurfacePart assembled() const
  {
    SurfacePart part{soup_.name, {}, {}};
    for (const Shell& shell : closed_)
      append(part, shell.surface);
    return part;
  }

  bool bounds_a_body(const SurfacePart& part) const
  {
    const SurfaceReport& after = report_.after;
    return after.balanced && encloses_volume(part) && after.volume > 0 &&
           (after.self_intersections == 0 || inverted_share(part) <= most_inverted);
  }

  // The last rung.
  void wrap(SurfacePart& part)
  {
    auto solid = wrap_as_solid(part, sizes_);
    const Wrapped wrapped = solid ? std::move(*solid) : wrap_as_sheet(part, sizes_);
    changed((solid ? "wrapped (" : "wrapped as a sheet (") + describe(wrapped) + ")");
    part = wrapped.skin;
    report_.after = check_surface(part);
    require(report_.after.balanced && report_.after.volume > 0,
            "even a wrap around it bounds no body; model it as a solid");
  }

  RepairSizes sizes_;
  const SurfacePart& original_;
  SurfacePart soup_, with_flat_;
  SurfacePart reference_; // the old surface less what was dropped
  std::vector<Shell> closed_;
  std::vector<SurfacePart> sheets_;
  double total_area_ = 0, gap_ = 0, widest_hole_ = 0;
  std::size_t holes_ = 0, large_holes_ = 0;
  bool body_changed_ = false; // more than dropped and flipped triangles
  PartRepair report_;
};

} // namespace

LadderResult climb_ladder(const SurfacePart& part, const SurfaceReport& before, const RepairSizes& sizes)
{
  return Ladder(part, before, sizes).climb();
}

} // namespace birdstrike
