// Every tolerance of the project, named here with its reason, and the robust predicates they go with.
// Lengths are relative: multiply by the mean edge length (or the face's size) of the mesh at hand.
#pragma once

#include <glm/vec2.hpp>

namespace netwright {

/// A net has no overlap deeper than this, in mean edge lengths (depth = least distance one face must move to
/// come free). `verify` decides by it. Six orders above rounding (about 1e-15), nine below anything paper
/// shows.
inline constexpr double kProofDepth = 1e-9;

/// The search counts an overlap from this depth on, in mean edges: well above the 1e-12 that rounding leaves
/// between faces that only touch in nets of thousands of faces, and, with the sqrt 2 of slack in its test,
/// below kSameCorner, so that everything it lets pass is a contact that `settle` can clear.
inline constexpr double kSolveDepth = 2e-11;

/// An overlap that helps to prove that there is no net is deeper than this, in mean edges: a thousand times
/// what a net may have, so that no doubtful contact ever stands in a proof, and far below what paper shows.
inline constexpr double kImpossibleDepth = 1e-6;

/// Corners of a stored net nearer to each other, or to a foreign edge, than this, in mean edges, touch: above
/// anything the search lets pass, far below kProofDepth.
inline constexpr double kSameCorner = 5e-11;

/// What people are told is an overlap, in mean edges: above what the search lets pass, in whichever order a
/// net is laid out, and below kProofDepth.
inline constexpr double kShownDepth = 1e-10;

/// A face is flat when no corner is off its best plane by more than this share of its longest side.
inline constexpr double kFlatness = 5e-4;

/// Folds bent by less than this (radians, one degree) are not drawn: they cannot be felt on paper.
inline constexpr double kFlatFold = 0.017453292519943295;

/// A face whose height is below this share of its longest side has no area to speak of: it is degenerate,
/// cannot be cut out and would make its own frame meaningless.
inline constexpr double kDegenerateHeight = 1e-9;

/// Corners of faces that came without shared points (STL, glTF) are one corner when they are closer than this
/// share of the model's diagonal: the float coordinates of such files differ by about 6e-8 of it when
/// programs rounded a corner twice, and no detail this small can be cut out.
inline constexpr double kWeldDistance = 1e-7;

/// Neighbouring faces bent by no more than this (radians, a tenth of a degree) may become one: over a hand's
/// breadth of paper it is a sixth of a millimetre, and more than what six written decimals tilt all but
/// slivers.
inline constexpr double kMergeAngle = 0.0017453292519943296;

/// Points of one plane that were rounded to floats may be off it by this share of the model's diagonal, and
/// slivers between them tilted by any angle. Applies at kMergeAngle and shrinks with the tolerance.
inline constexpr double kMergeRounding = 1e-7;

/// What double arithmetic leaves of exact coplanarity, as a share of the model's diagonal.
inline constexpr double kSamePlane = 1e-12;

/// Texture coordinates (the picture is 1 wide) nearer than this are the same: a quarter of a pixel of a
/// picture a thousand pixels wide.
inline constexpr double kSameUv = 2.5e-4;

/// Two faces cut through each other in space when they do so by more than this share of the larger one's
/// size. Shallower contact is what six written decimals leave between faces that touch, and far below a
/// sheet's thickness.
inline constexpr double kCrossingDepth = 1e-5;

/// Sign of the area of the triangle a b c, exact for every finite double: +1 counter-clockwise, -1 clockwise,
/// 0 collinear. (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997: the filtered
/// determinant, then an exact expansion.)
int orientation(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

}  // namespace netwright
