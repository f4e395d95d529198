//! Complementary bases.

/// A complementary basis: from every pair (w_i, z_i) one variable is basic, the other is zero.
///
/// Write α for the set of i with z_i basic. The basis is regular when the principal block M_αα is, and then
/// stands for the point z_α = −M_αα⁻¹ q_α, z = 0 elsewhere, w = M z + q.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Basis {
    basic_z: Vec<bool>,
}

impl Basis {
    /// The basis of all slacks, α = ∅, of a problem with n rows.
    #[must_use]
    pub fn slack(n: usize) -> Self {
        Self { basic_z: vec![false; n] }
    }

    /// The basis with the given α; indices of n or more are left out.
    pub fn from_indices(n: usize, alpha: impl IntoIterator<Item = usize>) -> Self {
        let mut basic_z = vec![false; n];
        for i in alpha {
            if let Some(entry) = basic_z.get_mut(i) {
                *entry = true;
            }
        }
        Self { basic_z }
    }

    /// Whether z_i is basic.
    #[must_use]
    pub fn contains(&self, i: usize) -> bool {
        self.basic_z.get(i).copied().unwrap_or(false)
    }

    /// The i with z_i basic, in increasing order.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.basic_z.iter().enumerate().filter(|(_, basic)| **basic).map(|(i, _)| i)
    }

    /// How many z_i are basic.
    #[must_use]
    pub fn count(&self) -> usize {
        self.basic_z.iter().filter(|basic| **basic).count()
    }

    /// The number n of pairs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.basic_z.len()
    }

    /// Whether there is no pair at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.basic_z.is_empty()
    }
}
