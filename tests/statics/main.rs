//! What contact forces could balance, whatever the fingers press.

mod closure;
