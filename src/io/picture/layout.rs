//! Sizes and positions of the elements of pictures, one list for each kind of picture.
//!
//! Lengths are in pixels unless they are said to be fractions of the span of a grasp, which is its largest extent along an axis. A fingertip is a
//! contact with all its points; a still picture is an SVG of a grasp in space.

use super::palette::Rgb;
use super::sheet::PaperPoint;

/// Sizes of marks that planar and spatial pictures of a grasp share.
pub(super) struct MarkLayout {
    /// Length of a friction cone, as a multiple of the length of the arrow of the normal force in it.
    pub(super) cone: f64,
    /// The arrow of a load is at least this long: a shorter arrow is lengthened, so that it is visible.
    pub(super) shortest_load: f64,
    /// Radius of the arc of a moment in the plane.
    pub(super) moment_arc: f64,
    /// The names of fingertips are written only if there are at most this number of fingertips.
    pub(super) most_named: usize,
}

pub(super) const MARKS: MarkLayout =
    MarkLayout { cone: 1.15, shortest_load: 18.0, moment_arc: 30.0, most_named: 30 };

/// Sizes in the picture of a grasp in the plane.
pub(super) struct PlanarLayout {
    /// Height of letters, pixels.
    pub(super) letters: f64,
    /// Length of the finger drawn behind its contact, as a fraction of the span. The name of the fingertip stands at this distance from the contact.
    pub(super) finger: f64,
    /// Largest number of fingertips up to which names are written with state and force; with more fingertips, names are written alone.
    pub(super) most_labelled: usize,
}

pub(super) const PLANAR: PlanarLayout = PlanarLayout { letters: 15.0, finger: 0.08, most_labelled: 12 };

/// Sizes in the picture of a grasp in space.
pub(super) struct SpatialLayout {
    /// Length of the finger drawn behind its contact, as a fraction of the span.
    pub(super) finger: f64,
    /// Length of the arrow that shows the direction of a slip, as a fraction of the span. The length says nothing about the magnitude of the slip.
    pub(super) slip: f64,
    /// Half the length of the drawn axis of a free motion, i.e. of a motion of the object that no contact resists, as a fraction of the span.
    pub(super) axis: f64,
    /// Radius of the dot of a contact.
    pub(super) contact: f64,
    /// Radius of the dot of a point of a soft fingertip.
    pub(super) soft_point: f64,
    /// Lengths of the dashes, and of the gaps between dashes, in the outline of the displaced object.
    pub(super) moved_dashes: (f64, f64),
}

pub(super) const SPATIAL: SpatialLayout = SpatialLayout {
    finger: 0.12,
    slip: 0.09,
    axis: 0.75,
    contact: 5.5,
    soft_point: 2.5,
    moved_dashes: (5.0, 4.0),
};

/// Sizes in the still picture (SVG) of a grasp in space.
pub(super) struct StillLayout {
    pub(super) margin: f64,
    /// Width and height of the area for the grasp, pixels.
    pub(super) room: (f64, f64),
    /// Letter height of names.
    pub(super) names: f64,
    /// Size of the area for the coordinate axes and their letters, pixels.
    pub(super) axes_room: f64,
}

pub(super) const STILL: StillLayout =
    StillLayout { margin: 12.0, room: (600.0, 520.0), names: 15.0, axes_room: 110.0 };

/// Sizes in the legend beside the still picture of a grasp in space.
pub(super) struct LegendLayout {
    /// Left edge of the legend.
    pub(super) left: f64,
    /// Length of the samples of lines and arrows.
    pub(super) sample: f64,
    /// Height of a line of the legend.
    pub(super) line: f64,
    /// Space between two entries.
    pub(super) between: f64,
}

pub(super) const LEGEND: LegendLayout = LegendLayout { left: 624.0, sample: 40.0, line: 18.0, between: 7.0 };

/// Sizes in a chart with two axes.
pub(super) struct ChartLayout {
    /// Size of one chart.
    pub(super) size: PaperPoint,
    /// Height of letters of the title.
    pub(super) title: f64,
    /// Height of letters of axes and legend.
    pub(super) letters: f64,
    /// Height of the letters that label vertical lines in the chart.
    pub(super) label: f64,
    /// Height of letters of notes, and of labels on a light background.
    pub(super) plaque: f64,
    /// Line height of the note below a chart.
    pub(super) note_line: f64,
    /// With at most this number of series the legend is inside the chart, with more series it is beside the chart.
    pub(super) most_inside: usize,
    /// Largest number of letters of a series' name beside the chart; a longer name is cut off.
    pub(super) longest_beside: usize,
    /// Largest number of letters of a series' name in the legend inside the chart; a longer name is cut off.
    pub(super) longest_inside: usize,
    /// Largest number of letters of a contact's name in the label of a vertical line; a longer name is cut off.
    pub(super) mark_letters: usize,
    /// Largest number of names in the note that lists the contacts without a curve; the note counts the others.
    pub(super) listed_names: usize,
    /// Largest number of letters of each name in the note that lists the contacts without a curve.
    pub(super) listed_letters: usize,
}

pub(super) const CHART: ChartLayout = ChartLayout {
    size: (860.0, 540.0),
    title: 18.5,
    letters: 14.0,
    label: 13.0,
    plaque: 11.5,
    note_line: 17.0,
    most_inside: 6,
    longest_beside: 26,
    longest_inside: 70,
    mark_letters: 26,
    listed_names: 12,
    listed_letters: 60,
};

/// Sizes in a chart over directions in the plane.
pub(super) struct PolarLayout {
    pub(super) middle: PaperPoint,
    /// Radius of the rim of the chart.
    pub(super) radius: f64,
    /// Left edge of the legend.
    pub(super) legend: f64,
    /// Length of the samples of curves in the legend.
    pub(super) sample: f64,
    /// Two texts at the rim are too close to each other if the angle between their directions, rad, is smaller than this.
    pub(super) beside: f64,
}

pub(super) const POLAR: PolarLayout =
    PolarLayout { middle: (330.0, 340.0), radius: 225.0, legend: 630.0, sample: 22.0, beside: 0.12 };

/// Sizes in a map over directions in space: two discs, one for each hemisphere, and a colour scale beside them.
pub(super) struct SphereLayout {
    pub(super) wide: f64,
    /// Radius of both discs.
    pub(super) radius: f64,
    /// Middles of both discs.
    pub(super) discs: [PaperPoint; 2],
    /// Vertical position of the first line of notes below the map.
    pub(super) foot: f64,
    /// Colour of directions with an infinite value.
    pub(super) unbounded: Rgb,
    /// Colour of directions without a value.
    pub(super) missing: Rgb,
}

pub(super) const SPHERE: SphereLayout = SphereLayout {
    wide: 860.0,
    radius: 165.0,
    discs: [(200.0, 268.0), (590.0, 268.0)],
    foot: 510.0,
    unbounded: Rgb(255, 246, 214),
    missing: Rgb(190, 190, 190),
};
