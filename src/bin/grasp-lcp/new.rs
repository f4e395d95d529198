//! Example scenes as starting points.

use clap::ValueEnum;

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
    /// The scene as text.
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

/// The meaning of the fields in these scenes, for the help and the manual: JSON has no comments.
pub(crate) const FIELDS_HELP: &str = "\
What stands in the scenes:
  format             the version, always \"grasp-lcp/1\"
  comment            a text for the reader; nothing looks at it
  planar, spatial    the plane, with two numbers a point, or space with three
  contacts           where the object is touched; one entry each
  name               what answers and messages call it
  point              where it touches, m
  normal             the direction into the object, the way the finger pushes; its length does not count
  series_stiffness   [normal, tangential], N/m: how finger and object give way there; or one number for all directions,
                     or nothing: a warning says where the answer depends on what is then taken
  friction           the coefficient of friction μ; 0 if left out
  pressed_with       the squeeze, N: the contact's spring is wound up so far, and the object gives way until forces
                     agree; a warning says where a contact then presses with something else
  clearance          a gap before anything touches, m; negative for an overlap
  tangent            the direction of the first tangent, along which the first side of a rectangular pad lies; if left out, the sides
                     lie along y and z for a normal along x, along x and z for one along y, and along x and y for one along z
  soft               a soft pad in place of a point, which resists twisting and tilting: a rectangle with its sides, m,
                     or a ring of a radius, m, with so many points on it; more strips are nearer to a uniform pad and cost time
  suction            a suction cup in place of a point: the radius of its lip, m, and the pressure of its vacuum below that
                     of the air around, Pa
  force              a normal force that stays wherever the object goes, N: an air cylinder, a clamp
  fingers            fingers with joints, and their contacts
  joints             from the palm on: where it turns (revolute, a point), how stiff its motor is (stiffness, N m/rad),
                     how far it is told to close (command, rad), where it stalls (limit, saturates, N m)
  tendons            over the joints of all fingers: one arm for each joint (arms, m/rad, of a slide 1), how stiff the motor is (stiffness, N/m), how
                     far it pulls (pull, m); a finger on a tendon is pressed by its pull, not by pressed_with
  unit               beside format: the unit of lengths, such as \"mm\"; forces and stiffnesses stay in N and N/m
  outline            corners of the object, m; only drawn
  part               the grasped part as a mesh: an STL or OBJ, with a unit and a mass, kg, or density, kg/m³
  touches            a pad that closes on the part, in place of point and normal: its sides, m (rectangle), its middle
                     before it closes, m (from), the direction (closing), and its elastic layer in place of a stiffness
                     (modulus, Pa, and thickness, m)
  bodies             several bodies, with a mass, kg, and its place (centre_of_mass); contacts and links then name theirs (on,
                     against), and gravity, m/s², pulls at each
  links              hinges (hinge), and bolts, straps and ropes (cable, from one point to another, m), with the tension at
                     which they are installed, N
  pair               a soft pad of the plane with two edges, and its width, m
  questions          what is asked, in order:
  hold               does it hold the load, beside the base that is there at rest?
  need               how much of a quantity (squeeze, friction, load, arm, angle) does the load take?
                     any_force is a force of any direction, N, at a point; the demand \"sticks\" is that nothing slides
  load, base         a force, N, and where it acts: at, m; the origin if left out. Or a moment, N m; or a mass, which may be
                     accelerated, m/s²
  per_metre          of an arm: the moment of the load for each metre, N

  grasp-lcp new gripper > gripper.json
  grasp-lcp ask gripper.json                   answers its questions
  grasp-lcp hold gripper.json --mass 0.8       and another one
  grasp-lcp draw gripper.json                  shows whether all is where it is meant to be

Lengths are in m, forces in N, stiffnesses in N/m; `grasp-lcp values` has ordinary ones and friction. All other fields: `grasp-lcp help scene`.";
