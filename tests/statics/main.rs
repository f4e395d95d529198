//! Statics: which loads contact forces could balance, whatever the fingers press.

mod closure;
mod ferrari_canny;
mod load_limit;
mod vacuum;
