//! Verdicts for all time against cycles that are followed one after the other.
