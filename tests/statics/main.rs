//! Loads that contact forces could balance, for any squeeze.

mod closure;
mod ferrari_canny;
mod load_limit;
mod vacuum;
