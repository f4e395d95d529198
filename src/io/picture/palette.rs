//! Colours and font of all pictures.

use plotters::style::RGBColor;

/// Eight colours that remain distinct for colour-blind readers (Okabe & Ito 2008), black last.
pub(super) const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(160, 140, 20),
    RGBColor(0, 0, 0),
];
pub(super) const BLUE: RGBColor = PALETTE[0];
pub(super) const VERMILION: RGBColor = PALETTE[1];
pub(super) const GREEN: RGBColor = PALETTE[2];
pub(super) const ORANGE: RGBColor = PALETTE[4];
pub(super) const GREY: RGBColor = RGBColor(110, 110, 110);
/// Colour of displacements.
pub(super) const PINK: RGBColor = PALETTE[3];
/// Colour of free motions.
pub(super) const SKY: RGBColor = RGBColor(58, 143, 200);
/// Colour of slips.
pub(super) const BROWN: RGBColor = RGBColor(122, 54, 0);
/// Colours of lines at rest, of the faces of a solid object, and of its contour.
pub(super) const FIXTURE: RGBColor = RGBColor(204, 204, 204);
pub(super) const FACE: RGBColor = RGBColor(238, 239, 241);
pub(super) const CONTOUR: RGBColor = RGBColor(150, 150, 150);
pub(super) const FONT: &str = "sans-serif";

/// A colour as CSS writes it.
pub(super) fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
