//! Lists, sums, counts, extremes and searches over lists or index ranges. The functions of this file replace std's iterators, which are compiled anew
//! for each function that uses them.

use nalgebra::{DMatrix, DVector};

use crate::prelude::*;

/// `f` of each element, in order.
pub(crate) fn mapped<'a, T, U>(list: &'a [T], f: &dyn Fn(&'a T) -> U) -> Vec<U> {
    let mut all = Vec::with_capacity(list.len());
    for element in list {
        all.push(f(element));
    }
    all
}

/// `f` of the numbers from 0 to `count` − 1, in order.
pub(crate) fn numbered<U>(count: usize, f: &dyn Fn(usize) -> U) -> Vec<U> {
    let mut all = Vec::with_capacity(count);
    while all.len() < count {
        all.push(f(all.len()));
    }
    all
}

/// `f` of each element, in order; the first error of `f` is returned instead.
pub(crate) fn tried<'a, T, U, E>(list: &'a [T], f: &dyn Fn(&'a T) -> Result<U, E>) -> Result<Vec<U>, E> {
    let mut all = Vec::with_capacity(list.len());
    for element in list {
        all.push(f(element)?);
    }
    Ok(all)
}

/// The largest value of `f` over all elements; 0 if no value is positive.
pub(crate) fn largest<T>(list: &[T], f: &dyn Fn(&T) -> f64) -> f64 {
    let mut largest = 0.0_f64;
    for element in list {
        largest = largest.max(f(element));
    }
    largest
}

/// The largest magnitude of a list of numbers; 0 for an empty list.
pub(crate) fn amax(list: &[f64]) -> f64 {
    let mut largest = 0.0_f64;
    for x in list {
        largest = largest.max(x.abs());
    }
    largest
}

/// The sum of `f` over all elements, added in order.
pub(crate) fn summed<'a, T>(list: &'a [T], f: &dyn Fn(&'a T) -> f64) -> f64 {
    // -0.0 is the neutral element of addition; starting from 0.0 would change the sign of a sum of negative zeros.
    let mut sum = -0.0;
    for element in list {
        sum += f(element);
    }
    sum
}

/// `f` of each element by value, in order.
pub(crate) fn moved<T, U>(list: Vec<T>, f: &dyn Fn(T) -> U) -> Vec<U> {
    let mut all = Vec::with_capacity(list.len());
    for element in list {
        all.push(f(element));
    }
    all
}

/// `f` of each element with its index, in order.
pub(crate) fn indexed<'a, T, U>(list: &'a [T], f: &dyn Fn((usize, &'a T)) -> U) -> Vec<U> {
    let mut all = Vec::with_capacity(list.len());
    for (position, element) in list.iter().enumerate() {
        all.push(f((position, element)));
    }
    all
}

/// `f` of the elements with equal index in two lists, up to the end of the shorter list.
pub(crate) fn paired<'a, 'b, T, U, V>(
    one: &'a [T],
    other: &'b [U],
    f: &dyn Fn((&'a T, &'b U)) -> V,
) -> Vec<V> {
    let mut all = Vec::with_capacity(one.len().min(other.len()));
    for position in 0..one.len().min(other.len()) {
        all.push(f((&one[position], &other[position])));
    }
    all
}

/// The values of `f` that are not `None`, in order.
pub(crate) fn picked<'a, T, U>(list: &'a [T], f: &dyn Fn(&'a T) -> Option<U>) -> Vec<U> {
    let mut all = Vec::new();
    for element in list {
        if let Some(value) = f(element) {
            all.push(value);
        }
    }
    all
}

/// Removes all elements of a list for which `is_kept` is false; the others stay in order.
pub(crate) fn keep<T>(list: &mut Vec<T>, is_kept: &dyn Fn(&T) -> bool) {
    list.retain(|element| is_kept(element));
}

/// The numbers from 0 to `count` − 1 for which `keeps` is true, in order.
pub(crate) fn chosen(count: usize, keeps: &dyn Fn(&usize) -> bool) -> Vec<usize> {
    let mut all = Vec::new();
    for k in 0..count {
        if keeps(&k) {
            all.push(k);
        }
    }
    all
}

/// Whether `is_meant` is true for any number from 0 to `count` − 1.
pub(crate) fn any_index(count: usize, is_meant: &dyn Fn(usize) -> bool) -> bool {
    let mut k = 0;
    while k < count && !is_meant(k) {
        k += 1;
    }
    k < count
}

/// Whether `is_meant` is true for every number from 0 to `count` − 1.
pub(crate) fn every_index(count: usize, is_meant: &dyn Fn(usize) -> bool) -> bool {
    !any_index(count, &|k| !is_meant(k))
}

/// The least value of `f` over all elements; infinite for an empty list.
pub(crate) fn least<'a, T>(list: &'a [T], f: &dyn Fn(&'a T) -> f64) -> f64 {
    let mut least = f64::INFINITY;
    for element in list {
        least = least.min(f(element));
    }
    least
}

/// The first element with the least value of `f`; `None` for an empty list.
pub(crate) fn lowest<'a, T>(list: &'a [T], f: &dyn Fn(&'a T) -> f64) -> Option<&'a T> {
    let mut lowest = list.first()?;
    for element in &list[1..] {
        if f(element).total_cmp(&f(lowest)).is_lt() {
            lowest = element;
        }
    }
    Some(lowest)
}

/// The last element with the greatest value of `f`; `None` for an empty list.
pub(crate) fn highest<'a, T>(list: &'a [T], f: &dyn Fn(&'a T) -> f64) -> Option<&'a T> {
    let mut highest = list.first()?;
    for element in &list[1..] {
        if f(element).total_cmp(&f(highest)).is_ge() {
            highest = element;
        }
    }
    Some(highest)
}

/// The number of elements for which `is_meant` is true.
pub(crate) fn counted<T>(list: &[T], is_meant: &dyn Fn(&T) -> bool) -> usize {
    let mut count = 0;
    for element in list {
        count += usize::from(is_meant(element));
    }
    count
}

/// The sum of `f` over the numbers from 0 to `count` − 1, added in order.
pub(crate) fn total(count: usize, f: &dyn Fn(usize) -> f64) -> f64 {
    let mut sum = -0.0;
    for k in 0..count {
        sum += f(k);
    }
    sum
}

/// The dot product of two lists, added in order.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sum = -0.0;
    for (a, b) in a.iter().zip(b) {
        sum += a * b;
    }
    sum
}

/// The vector of `f` of the numbers from 0 to `rows` − 1.
pub(crate) fn vector_of(rows: usize, f: &dyn Fn(usize) -> f64) -> DVector<f64> {
    DVector::from_vec(numbered(rows, f))
}

/// The matrix whose entry in each row and column is `f` of their indices.
pub(crate) fn matrix_of(rows: usize, columns: usize, f: &dyn Fn(usize, usize) -> f64) -> DMatrix<f64> {
    let mut all = Vec::with_capacity(rows * columns);
    for column in 0..columns {
        for row in 0..rows {
            all.push(f(row, column));
        }
    }
    DMatrix::from_vec(rows, columns, all)
}
