//! Example scenes as starting points.

use clap::ValueEnum;
#[cfg(feature = "mesh")]
use clap::{CommandFactory, parser::ValueSource};

#[cfg(feature = "mesh")]
use crate::arguments::Arguments;
#[cfg(feature = "mesh")]
use crate::failure::Failure;

/// An example scene, to be adapted.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum Template {
    /// Two soft jaws on a box.
    Gripper,
    /// Thumb and two fingers around a mug.
    ThreeFingers,
    /// A suction cup on a plate.
    Suction,
    /// Locators and clamps on a workpiece, in the plane.
    Fixture,
    /// Two fingers with a joint and a motor each, in the plane.
    Hand,
    /// A wedge in a gap, in the plane.
    Wedge,
    /// A block in a milling vise.
    Vise,
    /// A bar in a chuck, in the plane.
    Chuck,
    /// A plate under two bolts with play, in the plane.
    Bolts,
    /// A crate under a strap on a truck.
    TieDown,
    /// Lifting tongs on a block, in the plane.
    Tongs,
    /// A bar between a V and a flat jaw, in the plane.
    VJaws,
    /// Four suction cups that lift a sheet.
    Cups,
    /// A board on brackets, in the plane.
    Shelf,
    /// Two jaws on a part from a mesh: `new grip part.stl --jaws 20x30mm --closing 1,0,0 --force 40`; with `--ask` answered at once.
    #[cfg(feature = "mesh")]
    Grip,
}

impl Template {
    pub(crate) fn text(self) -> &'static str {
        match self {
            Self::Gripper => include_str!("../../../examples/scenes/everyday/gripper.json"),
            Self::ThreeFingers => include_str!("../../../examples/scenes/everyday/mug.json"),
            Self::Suction => include_str!("../../../examples/scenes/everyday/suction.json"),
            Self::Fixture => include_str!("../../../examples/scenes/everyday/fixture.json"),
            Self::Hand => include_str!("../../../examples/scenes/everyday/hand.json"),
            Self::Wedge => include_str!("../../../examples/scenes/everyday/wedge.json"),
            Self::Vise => include_str!("../../../examples/scenes/shop/vise.json"),
            Self::Chuck => include_str!("../../../examples/scenes/shop/chuck.json"),
            Self::Bolts => include_str!("../../../examples/scenes/shop/bolts.json"),
            Self::TieDown => include_str!("../../../examples/scenes/shop/tie_down.json"),
            Self::Tongs => include_str!("../../../examples/scenes/bodies/scissor.json"),
            Self::VJaws => include_str!("../../../examples/scenes/shop/v_jaws.json"),
            Self::Cups => include_str!("../../../examples/scenes/shop/cups.json"),
            Self::Shelf => include_str!("../../../examples/scenes/shop/shelf.json"),
            #[cfg(feature = "mesh")]
            Self::Grip => "",
        }
    }
}

/// Refuses options that belong to `new grip` if the command line asks for another template.
#[cfg(feature = "mesh")]
pub(crate) fn refuse_options_of_grip() -> Result<(), Failure> {
    let mut command = Arguments::command();
    let Ok(matches) = command.try_get_matches_from_mut(std::env::args_os()) else { return Ok(()) };
    let (Some(of_new), Some(given)) = (command.find_subcommand("new"), matches.subcommand_matches("new"))
    else {
        return Ok(());
    };
    for argument in of_new.get_arguments().filter(|argument| argument.get_id() != "of") {
        let id = argument.get_id().as_str();
        if given.ids().any(|known| known == id) && given.value_source(id) == Some(ValueSource::CommandLine) {
            let option = argument.get_long().map_or_else(|| id.to_owned(), |long| format!("--{long}"));
            return Err(Failure::Usage(format!(
                "{option}: of `new grip` alone, must be left out; other scenes are adapted in their text"
            )));
        }
    }
    Ok(())
}

/// The meaning of the fields in the example scenes, for the help and the manual: the scenes are JSON, which has no comments.
pub(crate) const FIELDS_HELP: &str = include_str!("fields_of_templates.txt");
