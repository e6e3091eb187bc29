// SPDX-License-Identifier: GPL-3.0-or-later
// Which way a bird in a mesh flies, and which way is up.
#include "geometry/import/find_axes.h"

#include "core/error.h"
#include "geometry/import/axis_evidence.h"
#include "geometry/import/symmetry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace birdstrike {

namespace {

using Matrix3 = Eigen::Matrix3d;
constexpr double symmetric = 0.1; // largest asymmetry() of a mirror plane

Vector3 direction(const std::string& text, const char* what)
{
  std::size_t at = 0;
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+'))
    at = 1;
  const char axis = at + 1 == text.size() ? char(text[at] | 0x20) : '?'; // to a small letter
  require(axis >= 'x' && axis <= 'z',
          std::string(what) + " = \"" + text +
              "\" is no direction of the mesh file; write one of +x, -x, +y, -y, +z, -z");
  return (negative ? -1.0 : 1.0) * Vector3::Unit(axis - 'x');
}

std::string text_of(const Vector3& axis)
{
  Eigen::Index i = 0;
  if (axis.cwiseAbs().maxCoeff(&i) > 1 - 1e-9)
    return std::string(axis[i] < 0 ? "-" : "+") + "xyz"[i];
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", axis.x(), axis.y(), axis.z());
  return text;
}

bool across(const Vector3& a, const Vector3& b) { return std::abs(a.dot(b)) < 0.1; }
bool along(const Vector3& a, const Vector3& b) { return std::abs(a.dot(b)) > 0.9; }

class Search
{
public:
  Search(const SurfaceMesh& parts, const KnownAxes& known)
      : samples_(sample_surface(parts)), evidence_(find_evidence(parts))
  {
    if (!known.nose.empty())
      nose_ = direction(known.nose, "nose");
    if (!known.up.empty())
      up_ = direction(known.up, "up");
    if (!known.file_up.empty())
      file_up_ = direction(known.file_up, "up");
    require(!nose_ || !up_ || nose_->dot(*up_) == 0,
            "nose = \"" + known.nose + "\" and up = \"" + known.up + "\" of the mesh are not perpendicular");
  }

  FoundAxes find()
  {
    if (!nose_ || !up_) {
      if (!find_left()) {
        keep_file_axes("the bird has no mirror plane to find its axes by");
        return std::move(found_);
      }
      if (several_planes_ && !nose_ && !up_ && !file_up_ && !evidence_.left && !evidence_.nose) {
        keep_file_axes("the mesh is its own mirror image in several planes and nothing in it is named head, "
                       "neck or wing");
        return std::move(found_);
      }
      find_lines();
      find_nose();
      find_up();
    }
    found_.turn.row(0) = nose_->transpose();
    found_.turn.row(1) = up_->cross(*nose_).transpose();
    found_.turn.row(2) = up_->transpose();
    if (!found_.turn.isIdentity(1e-9))
      found_.notes.push_back("turned: the nose is " + text_of(*nose_) + " in the file, up is " +
                             text_of(*up_) + (why_.empty() ? "" : " (" + why_ + ")"));
    return std::move(found_);
  }

private:
  void because(const std::string& reason) { why_ += (why_.empty() ? "" : "; ") + reason; }

  double extent(const Vector3& axis) const
  {
    double low = INFINITY, high = -INFINITY;
    for (const Vector3& p : samples_.points) {
      low = std::min(low, p.dot(axis));
      high = std::max(high, p.dot(axis));
    }
    return high - low;
  }

  //! The normal of the middle plane, as the column of a frame.
  bool find_left()
  {
    for (const Matrix3& frame : {Matrix3(Matrix3::Identity()), principal_axes(samples_)}) {
      std::vector<int> fitting;
      for (int axis = 0; axis < 3; ++axis)
        if ((!nose_ || across(frame.col(axis), *nose_)) && (!up_ || across(frame.col(axis), *up_)) &&
            asymmetry(samples_, frame, axis) < symmetric)
          fitting.push_back(axis);
      if (fitting.empty())
        continue;
      const auto best = *std::max_element(fitting.begin(), fitting.end(),
                                          [&](int l, int r) { return claim(frame, l) < claim(frame, r); });
      frame_ = frame;
      left_ = best;
      several_planes_ = fitting.size() > 1;
      because("mirror plane across " + text_of(frame.col(best)) +
              (fitting.size() > 1 && !evidence_.left ? ", the widest of several" : ""));
      return true;
    }
    return false;
  }

  //! How much speaks for a direction across the bird: names of left and right, then the width.
  double claim(const Matrix3& frame, int axis) const
  {
    const Vector3 line = frame.col(axis);
    const bool named = evidence_.left && along(*evidence_.left, line);
    const bool upright = file_up_ && along(*file_up_, line);
    const bool lengthwise = evidence_.nose && along(*evidence_.nose, line);
    const bool as_in_file = along(line, Vector3::UnitY()); // wins where all are alike
    return extent(line) / extent_of_all() + (named ? 10 : 0) - (lengthwise ? 2 : 0) - (upright ? 1 : 0) +
           (as_in_file ? 0.03 : 0);
  }
  double extent_of_all() const
  {
    return std::max({extent(Vector3::UnitX()), extent(Vector3::UnitY()), extent(Vector3::UnitZ()), 1e-300});
  }

  //! Which of the two directions in the middle plane is the line from tail to nose, and which is up and down.
  void find_lines()
  {
    const Vector3 e = frame_.col((left_ + 1) % 3), f = frame_.col((left_ + 2) % 3);
    if (file_up_ && along(*file_up_, frame_.col(left_))) {
      found_.warnings.push_back("the format's up, " + text_of(*file_up_) +
                                ", lies across the bird's middle plane and is not believed");
      file_up_.reset();
    }
    const auto length = [&](const Vector3& line) {
      return extent(line) * (along(line, Vector3::UnitX()) ? 1.03 : 1); // as in the file where both are alike
    };
    bool e_is_long = length(e) > length(f);
    if (nose_)
      e_is_long = std::abs(e.dot(*nose_)) > std::abs(f.dot(*nose_));
    else if (up_ || file_up_) {
      const Vector3 up = up_ ? *up_ : *file_up_;
      e_is_long = std::abs(e.dot(up)) < std::abs(f.dot(up));
    } else if (evidence_.nose)
      e_is_long = std::abs(e.dot(*evidence_.nose)) > std::abs(f.dot(*evidence_.nose));
    long_ = e_is_long ? e : f;
    high_ = e_is_long ? f : e;
  }

  static Vector3 like(const Vector3& line, const Vector3& pointing)
  {
    return line.dot(pointing) < 0 ? Vector3(-line) : line;
  }

  void find_nose()
  {
    if (nose_)
      return;
    if (evidence_.nose && std::abs(evidence_.nose->dot(long_)) > 0.3) {
      nose_ = like(long_, *evidence_.nose);
      because("the nose is where " + evidence_.nose_source + " is");
    } else if (const double narrower = narrow_end(samples_, long_, frame_.col(left_)); narrower != 0) {
      nose_ = narrower * long_;
      because("the nose is the narrower end");
      found_.warnings.push_back("nothing is named head, neck or tail: the narrower end, " + text_of(*nose_) +
                                " in the file, is taken as the nose; look at a picture, or give the nose");
    } else {
      nose_ = like(long_, Vector3::Ones());
      found_.warnings.push_back("nothing tells nose from tail: " + text_of(*nose_) +
                                " in the file is taken as the nose; look at a picture, or give the nose");
    }
    if (up_) // given axes are exact, found ones follow
      nose_ = (*nose_ - nose_->dot(*up_) * *up_).normalized();
  }

  void find_up()
  {
    if (up_)
      return;
    const auto [sign, source, sure] = [&]() -> std::tuple<Vector3, std::string, bool> {
      if (file_up_)
        return {*file_up_, "up as the format says", true};
      if (evidence_.left && along(*evidence_.left, frame_.col(left_)))
        return {nose_->cross(like(frame_.col(left_), *evidence_.left)), "up by the names left and right",
                true};
      if (evidence_.down && std::abs(evidence_.down->dot(high_)) > 0.3)
        return {-*evidence_.down, "up is away from the legs", true};
      if (const double side = wing_side(samples_, high_, frame_.col(left_)); side != 0)
        return {side * high_, "the wings are on the upper side", false};
      return {Vector3::Ones(), "", false};
    }();
    up_ = like(high_, sign);
    up_ = (*up_ - up_->dot(*nose_) * *nose_).normalized();
    if (!source.empty())
      because(source);
    if (!sure)
      found_.warnings.push_back(
          (source.empty() ? "nothing tells back from belly: "
                          : "no name and no format tells back from belly, but the wings seem to: ") +
          text_of(*up_) + " in the file is taken as up; look at a picture, or give up");
  }

  void keep_file_axes(const std::string& reason)
  {
    if (nose_ || up_) { // half of it is given: the other half is the file's own, as near as may be
      const Vector3 given = nose_ ? *nose_ : *up_;
      const Vector3 other =
          nose_ ? (file_up_ && across(*file_up_, given) ? *file_up_ : Vector3(Vector3::UnitZ()))
                : Vector3(Vector3::UnitX());
      const Vector3 second = across(other, given) ? other : Vector3(Vector3::UnitY());
      const Vector3 nose = nose_ ? given : second, up = nose_ ? second : given;
      found_.turn << nose.transpose(), up.cross(nose).transpose(), up.transpose();
    } else if (file_up_ && evidence_.nose) {
      Vector3 nose = *evidence_.nose - evidence_.nose->dot(*file_up_) * *file_up_;
      Eigen::Index axis = 0;
      if (nose.cwiseAbs().maxCoeff(&axis) > 0.3) {
        nose = (nose[axis] < 0 ? -1.0 : 1.0) * Vector3::Unit(axis);
        found_.turn << nose.transpose(), file_up_->cross(nose).transpose(), file_up_->transpose();
      }
    }
    found_.warnings.push_back(reason + ": the nose is taken as " + text_of(found_.turn.row(0).transpose()) +
                              ", up as " + text_of(found_.turn.row(2).transpose()) +
                              " in the file; look at a picture, or give nose and up");
  }

  bool several_planes_ = false;
  SurfaceSamples samples_;
  AxisEvidence evidence_;
  std::optional<Vector3> nose_, up_, file_up_;
  Matrix3 frame_ = Matrix3::Identity();
  int left_ = 1;
  Vector3 long_ = Vector3::UnitX(), high_ = Vector3::UnitZ();
  std::string why_;
  FoundAxes found_;
};

} // namespace

FoundAxes find_axes(const SurfaceMesh& parts, const KnownAxes& known) { return Search(parts, known).find(); }

} // namespace birdstrike
