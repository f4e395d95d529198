//! Small dense linear algebra and sums, for every room above: it knows nothing of contacts.
//!
//! | file | idea |
//! |---|---|
//! | `orthogonal` | rank-revealing orthogonal factors of a tall matrix with graded rows |
//! | `complete_pivoting` | LU that says what it could not resolve |
//! | `cores` | work spread over the cores |
//! | `partial_pivoting` | LU of a matrix far from singular |
//! | `factors` | the one of the two that a matrix needs |
//! | `linearly_implicit` | one step of a stiff one |
//! | `student_t` | what differs from a mean by chance, where the scatter is estimated |
//! | `support` | convex sets that are known by their farthest points |
//! | `ray_shooting` | how far a ray stays in such a set |
//! | `largest_ball` | the largest ball about the origin in it |
//! | `harmonic` | what turns: numbers, vectors, wrenches |
//! | `trigonometric` | where a trigonometric polynomial first falls below zero |
//! | `on_a_circle` | where a number is smaller than a vector, while both turn |
//! | `nearest_point` | the nearest point of a polyhedral cone |
//! | `band` | LU of a matrix with entries near its diagonal alone |
//! | `narrow_order` | the order in which they are near it |
//! | `bordered` | LU of a matrix with one row and one column more |
//! | `bordered_band` | the same of a band |
//! | `dormand_prince` | one step of a differential equation |
//! | `double_double` | sums in twice the working precision |
//! | `normal_tail` | how often chance goes far |
//! | `exact_sum` | sums of products without rounding |
//! | `pairwise` | sums made of halves, on several threads |
//! | `unit_vector` | unit vectors along an axis |
//! | `waiting_line` | numbered things that wait for their time |
//! | `vector_dispatch` | loops on the widest vectors of the processor |
//! | `pseudo_random` | numbers without structure, the same on every machine |
//! | `square_root` | that of std by a name of its own |
//! | `cleared_for` | lists that are filled anew |
//! | `without_std` | what std does for all this, where there is none |

mod band;
mod bordered;
mod bordered_band;
mod cleared_for;
mod complete_pivoting;
mod coordinates;
#[cfg_attr(not(feature = "parallel"), path = "one_core.rs")]
mod cores;
mod dormand_prince;
mod double_double;
mod exact_sum;
mod factors;
mod harmonic;
mod largest_ball;
mod linearly_implicit;
mod memory;
mod narrow_order;
mod nearest_point;
mod normal_tail;
mod on_a_circle;
mod orthogonal;
mod pairwise;
mod partial_pivoting;
mod positive_band;
mod pseudo_random;
mod ray_shooting;
mod square_root;
mod student_t;
mod support;
mod trigonometric;
mod unit_vector;
mod vector_dispatch;
mod waiting_line;
#[cfg(any(test, not(feature = "std")))]
mod without_std;

pub(crate) use band::{Band, BandFactors};
pub(crate) use bordered::Bordered;
pub(crate) use bordered_band::BorderedBand;
pub(crate) use cleared_for::cleared_for;
pub(crate) use complete_pivoting::CompletePivoting;
pub(crate) use coordinates::{Any, Fixed, Map, Seen, Size, Square, Vector};
pub(crate) use cores::{each_taken, in_order};
pub(crate) use dormand_prince::{Stepped, explicit_step};
pub(crate) use double_double::{DoubleDouble, rounding_of};
pub(crate) use exact_sum::{ExactSum, times_power_of_two};
pub(crate) use factors::Factors;
pub(crate) use harmonic::Harmonic;
pub(crate) use largest_ball::largest_ball;
pub(crate) use linearly_implicit::implicit_step;
pub(crate) use memory::Memory;
pub(crate) use narrow_order::{narrow_order, widest};
pub(crate) use nearest_point::NearestPoint;
pub(crate) use normal_tail::{normal_density, normal_tail};
pub(crate) use on_a_circle::Turning;
pub(crate) use orthogonal::{Orthogonal, orthonormalise_against, without};
pub(crate) use pairwise::in_halves;
pub(crate) use partial_pivoting::PartialPivoting;
pub(crate) use positive_band::PositiveBand;
pub(crate) use pseudo_random::{Draw, generic};
pub(crate) use ray_shooting::{RayExit, shoot};
pub(crate) use square_root::square_root;
#[cfg(feature = "std")]
pub(crate) use std::sync::OnceLock as Once;
pub(crate) use student_t::two_sided;
pub(crate) use support::{Vertex, simplex};
pub(crate) use trigonometric::{Fall, Trigonometric};
pub(crate) use unit_vector::unit;
pub(crate) use vector_dispatch::{Compiled, Loop, OnVectors, Vectors, on_the_widest, wide};
pub(crate) use waiting_line::WaitingLine;
#[cfg(not(feature = "std"))]
pub(crate) use without_std::{FloatFunctions, Once};
