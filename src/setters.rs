//! Setters of builders, which change one field of a value and return the value.

/// Methods that take `self`, change it by one statement, and return it. The type is `#[must_use]`, so that the compiler warns if the result is dropped.
///
/// ```text
/// setters! {
///     /// Sets the seed of the random starts.
///     pub fn with_seed(mut self, seed: u64) { self.seed = Some(seed); }
/// }
/// ```
macro_rules! setters {
    ($($(#[$documentation:meta])* pub fn $name:ident(mut $self:ident $(, $argument:ident: $type:ty)*) $change:block)*) => {
        $(
            $(#[$documentation])*
            pub fn $name(mut $self $(, $argument: $type)*) -> Self {
                $change
                $self
            }
        )*
    };
}
