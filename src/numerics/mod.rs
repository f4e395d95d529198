//! Small dense linear algebra, sums and other numerical methods for all other modules. Nothing here depends on contacts.
//!
//! | file | idea |
//! |---|---|
//! | `coordinates` | vectors and matrices over the coordinates of a grasp |
//! | `orthogonal` | rank-revealing orthogonal factors of a tall matrix whose rows differ in magnitude by many decades |
//! | `gram_schmidt` | the Gram–Schmidt orthogonalisation for `orthogonal`, column by column |
//! | `orthonormal_set` | the component of a vector orthogonal to an orthonormal set |
//! | `complete_pivoting` | LU with rank, kernels and the part of a right-hand side outside the range |
//! | `cores` | parallel work on all cores |
//! | `partial_pivoting` | LU of a matrix far from singular |
//! | `few_equations` | elimination in place, for a few equations that are solved once |
//! | `factors` | LU with partial or complete pivoting, by condition |
//! | `linearly_implicit` | one step of a stiff ordinary differential equation |
//! | `student_t` | quantiles of Student's distribution |
//! | `tolerances` | limits below which a value is zero or rounding |
//! | `support` | convex sets described by support functions |
//! | `ray_shooting` | the point where a ray leaves a convex set |
//! | `regula_falsi` | the argument at which a function of one variable changes sign |
//! | `largest_ball` | the largest ball about the origin inside a convex set |
//! | `harmonic` | numbers, vectors and wrenches as harmonic functions of an angle |
//! | `trigonometric` | first sign change of a trigonometric polynomial |
//! | `on_a_circle` | angles at which one harmonic function is smaller than the norm of another |
//! | `least_distance` | the shortest vector that satisfies linear inequalities |
//! | `nearest_point` | the closest point of a polyhedral cone |
//! | `band` | LU of a band matrix |
//! | `positive_band` | Cholesky factors of a symmetric positive definite band matrix |
//! | `increasing` | sorting by a number |
//! | `narrow_order` | an order of coordinates that gives a narrow band |
//! | `bordered` | LU of a matrix bordered by one row and column |
//! | `bordered_band` | solution of a band matrix bordered by one row and column |
//! | `dormand_prince` | one step of an ordinary differential equation by a Runge-Kutta method |
//! | `double_double` | sums in double-double precision |
//! | `normal_tail` | upper tail of the normal distribution, of one variable and of two |
//! | `exact_sum` | sums of products without rounding |
//! | `pairwise` | pairwise summation, on several threads |
//! | `unit_vector` | unit vectors along an axis |
//! | `vector_dispatch` | loops on the widest vector instructions of the processor |
//! | `pseudo_random` | reproducible pseudorandom numbers |
//! | `square_root` | the square root of std under another name |
//! | `mapped` | lists, sums and extremes over lists or index ranges |
//! | `reals` | sums and extremes of the numbers of an iterator |
//! | `add_times` | sums and products of lists, in place |
//! | `cleared_for` | emptying of lists before they are filled again |
//! | `memory` | scratch buffers that one question leaves for the next |
//! | `without_std` | replacements for std where it is missing |

mod add_times;
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
mod each;
mod exact_sum;
mod factors;
mod few_equations;
mod gram_schmidt;
mod harmonic;
mod increasing;
mod into_list;
mod largest_ball;
mod least_distance;
mod linearly_implicit;
mod mapped;
mod memory;
mod narrow_order;
mod nearest_point;
mod normal_tail;
mod on_a_circle;
mod orthogonal;
mod orthonormal_set;
mod pairwise;
mod partial_pivoting;
mod positive_band;
mod pseudo_random;
mod ray_shooting;
mod reals;
mod regula_falsi;
mod singular;
mod space;
mod square_root;
mod student_t;
mod support;
pub(crate) mod tolerances;
mod trigonometric;
mod unit_vector;
mod vector_dispatch;
#[cfg(any(test, not(feature = "std")))]
mod without_std;

pub(crate) use add_times::{add_times, scale, scale_each};
pub(crate) use band::{Band, BandFactors};
pub(crate) use bordered::{Bordered, solved_once};
pub(crate) use bordered_band::BorderedBand;
pub(crate) use cleared_for::cleared_for;
pub(crate) use complete_pivoting::CompletePivoting;
pub(crate) use coordinates::{Indices, Map, Size, Square, Vector, WHOLE};
pub(crate) use cores::{each_taken, in_order};
pub(crate) use dormand_prince::{Stepped, explicit_step};
pub(crate) use double_double::{DoubleDouble, rounding_of};
pub(crate) use each::{Each, by_axis};
pub(crate) use exact_sum::{ExactSum, times_power_of_two};
pub(crate) use factors::Factors;
pub(crate) use few_equations::{Equation, MOST_UNKNOWNS, solved};
pub(crate) use harmonic::Harmonic;
pub(crate) use increasing::{increasing, sort_by_number};
pub(crate) use into_list::{IntoList, all_some};
pub(crate) use largest_ball::largest_ball;
pub(crate) use least_distance::least_distance;
pub(crate) use linearly_implicit::implicit_step;
pub(crate) use mapped::{
    amax, any_index, chosen, counted, dot, every_index, highest, indexed, keep, largest, least, lowest,
    mapped, matrix_of, moved, numbered, paired, picked, summed, total, tried, vector_of,
};
pub(crate) use memory::Memory;
pub(crate) use narrow_order::{narrow_order, widest};
pub(crate) use nearest_point::NearestPoint;
pub(crate) use normal_tail::{normal_density, normal_tail, tail_of_both};
pub(crate) use on_a_circle::Turning;
pub(crate) use orthogonal::Orthogonal;
pub(crate) use orthonormal_set::{orthogonal_part, orthonormalise_against, without};
pub(crate) use pairwise::in_halves;
pub(crate) use partial_pivoting::PartialPivoting;
pub(crate) use positive_band::PositiveBand;
pub(crate) use pseudo_random::{Draw, generic};
pub(crate) use ray_shooting::{RayExit, shoot};
pub(crate) use reals::Reals;
pub(crate) use regula_falsi::regula_falsi;
pub(crate) use singular::{Singular, symmetric_eigen};
pub(crate) use space::Space;
pub(crate) use square_root::square_root;
#[cfg(feature = "std")]
pub(crate) use std::sync::OnceLock as Once;
pub(crate) use student_t::two_sided;
pub(crate) use support::{Vertex, simplex};
pub(crate) use trigonometric::{FirstZero, Trigonometric};
pub(crate) use unit_vector::unit;
pub(crate) use vector_dispatch::{Compiled, Loop, OnVectors, Vectors, on_the_widest, wide};
#[cfg(not(feature = "std"))]
pub(crate) use without_std::{FloatFunctions, Once};
