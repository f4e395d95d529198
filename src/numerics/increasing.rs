//! Sorting by a number, with one sort that is compiled once.

use crate::numerics::{IntoList, mapped};
use crate::prelude::*;

/// The indices of these values from the lowest to the highest; equal values keep their order. For the reverse order, negate the values.
pub(crate) fn increasing(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).list();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}

/// Sorts a list by a number of each element, from the lowest to the highest; elements with equal numbers keep their order.
pub(crate) fn sort_by_number<T>(list: &mut [T], number: &dyn Fn(&T) -> f64) {
    let order = increasing(&mapped(list, number));
    for place in 0..order.len() {
        // Finds the present position `from` of the element that belongs at `place`. If it came from an earlier position, it has been swapped away
        // from there, along the cycle of the permutation.
        let mut from = order[place];
        while from < place {
            from = order[from];
        }
        list.swap(place, from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::Draw;

    #[test]
    fn sorts_as_the_standard_library_does() {
        for count in 0..40 {
            let mut numbers = Draw::new([count as u64, 0, 0]);
            // Many numbers are equal, so that the second entry shows whether equal elements keep their order.
            let mut list: Vec<(f64, usize)> =
                (0..count).map(|k| ((7.0 * numbers.uniform()).floor(), k)).list();
            let mut sorted = list.clone();
            sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
            sort_by_number(&mut list, &|(number, _)| *number);
            assert_eq!(list, sorted);
        }
    }
}
