//! Colours and font of all pictures.

/// A colour by its red, green and blue components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rgb(pub(super) u8, pub(super) u8, pub(super) u8);

impl Rgb {
    /// The colour between this colour and `other`, at the fraction `part` of the difference.
    pub(super) fn towards(self, other: Self, part: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two colours")]
        let mixed = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
        Self(mixed(self.0, other.0), mixed(self.1, other.1), mixed(self.2, other.2))
    }

    /// The colour with an opacity below one, so that strokes below remain visible.
    pub(super) fn mix(self, opacity: f64) -> Ink {
        Ink { color: self, opacity }
    }
}

/// A colour with its opacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ink {
    pub(super) color: Rgb,
    pub(super) opacity: f64,
}

impl From<Rgb> for Ink {
    fn from(color: Rgb) -> Self {
        color.mix(1.0)
    }
}

pub(super) const BLACK: Rgb = Rgb(0, 0, 0);
pub(super) const WHITE: Rgb = Rgb(255, 255, 255);

/// Eight colours that remain distinct for colour-blind readers (Okabe & Ito 2008), black last.
pub(super) const PALETTE: [Rgb; 8] = [
    Rgb(0, 114, 178),
    Rgb(213, 94, 0),
    Rgb(0, 158, 115),
    Rgb(204, 121, 167),
    Rgb(230, 159, 0),
    Rgb(86, 180, 233),
    Rgb(160, 140, 20),
    Rgb(0, 0, 0),
];
pub(super) const BLUE: Rgb = PALETTE[0];
pub(super) const VERMILION: Rgb = PALETTE[1];
pub(super) const GREEN: Rgb = PALETTE[2];
pub(super) const ORANGE: Rgb = PALETTE[4];
pub(super) const GREY: Rgb = Rgb(110, 110, 110);
/// Colour of displacements of the object.
pub(super) const PINK: Rgb = PALETTE[3];
/// Colour of free motions, i.e. of motions of the object that no contact resists.
pub(super) const SKY: Rgb = Rgb(58, 143, 200);
/// Colour of the arrows that show in which direction fingers slip over the object.
pub(super) const BROWN: Rgb = Rgb(122, 54, 0);
/// Colour of fixtures, i.e. of lines on things that do not move.
pub(super) const FIXTURE: Rgb = Rgb(204, 204, 204);
/// Colour of the faces of a solid object.
pub(super) const FACE: Rgb = Rgb(238, 239, 241);
/// Colour of the contour of a solid object.
pub(super) const CONTOUR: Rgb = Rgb(150, 150, 150);
pub(super) const FONT: &str = "sans-serif";

/// A colour as CSS writes it.
pub(super) fn hex(Rgb(red, green, blue): Rgb) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
