//! Loads on several bodies that grow in proportion to the load on the object, which is the body that loads act on. The base load acts before these
//! loads grow.

use alloc::borrow::Cow;
use alloc::collections::BTreeMap;

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::prelude::*;

impl<const C: usize> Grasp<C> {
    /// This grasp with the loads `others` on further bodies, by name, which grow in proportion to `load`, the single load of a scene's question.
    /// `load` is `None` if the question has several loads or none. Returns this grasp itself if `others` is empty.
    pub(crate) fn growing(
        &self,
        question: &'static str,
        base: Wrench<C>,
        load: Option<Wrench<C>>,
        others: &BTreeMap<String, Wrench<C>>,
    ) -> Result<Cow<'_, Self>, Error> {
        check_growing(question, base, load, others)?;
        match load {
            Some(load) if !others.is_empty() => {
                self.growing_together(&load, others.iter().map(|(name, load)| (name, *load))).map(Cow::Owned)
            }
            _ => Ok(Cow::Borrowed(self)),
        }
    }
}

/// Checks whether loads on bodies can grow in proportion to the load of a scene's question. Returns an error if the question has several loads, a
/// zero load, or a base load.
pub(crate) fn check_growing<const C: usize>(
    question: &'static str,
    base: Wrench<C>,
    load: Option<Wrench<C>>,
    others: &BTreeMap<String, Wrench<C>>,
) -> Result<(), Error> {
    let refuse = |fault| Err(Error::Question { question, field: "together_with", fault });
    match load {
        _ if others.is_empty() => Ok(()),
        None => refuse(
            "given, must be left out unless the amount is one of squeeze, friction or load, for one load",
        ),
        _ if base != Wrench::ZERO => {
            refuse("given, must be left out beside a base: what is always there is the `load` of a body")
        }
        Some(load) if load == Wrench::ZERO => refuse("given, must be left out without a load to grow with"),
        Some(_) => Ok(()),
    }
}
