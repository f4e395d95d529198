//! A house of cards: rows of cards that lean on each other in pairs, and between two rows cards that lie on the tops of the lower row.

use grasp_lcp::planar::{Bodies, Body, Contact};

/// Mass of a card, kg, its length, m, its angle to the vertical, rad, and how far the tops of a pair are apart, m.
const MASS: f64 = 0.0018;
const LENGTH: f64 = 0.09;
const LEANS: f64 = 0.436;
const APART: f64 = 0.002;
const GRAVITY: f64 = 9.81;

/// A point where a card touches another card or the table.
struct Touching {
    on: usize,
    against: Option<usize>,
    point: [f64; 2],
    normal: [f64; 2],
}

/// A house of cards.
pub struct HouseOfCards {
    /// Centre of mass of each card, m.
    centres: Vec<[f64; 2]>,
    touches: Vec<Touching>,
}

impl HouseOfCards {
    /// A house with this number of rows; it has `rows (3 rows + 1) / 2` cards in all.
    #[must_use]
    pub fn of(rows: usize) -> Self {
        let (half, high) = (LENGTH * LEANS.sin(), LENGTH * LEANS.cos());
        let wide = 2.0 * (half + APART);
        let (mut centres, mut touches) = (Vec::new(), Vec::new());
        let mut lying: Vec<usize> = Vec::new();
        for row in 0..rows {
            let (below, above) = (high * row as f64, high * (row + 1) as f64);
            let middle = |pair: usize| wide * (pair as f64 + 0.5 * row as f64);
            let first = centres.len();
            for pair in 0..rows - row {
                for (side, on) in [-1.0, 1.0].into_iter().zip(centres.len()..) {
                    centres.push([middle(pair) + side * 0.5 * (half + APART), 0.5 * (below + above)]);
                    let point = [middle(pair) + side * (half + 0.5 * APART), below];
                    touches.push(Touching {
                        on,
                        against: lying.get(pair).copied(),
                        point,
                        normal: [0.0, 1.0],
                    });
                }
                let pair_of = centres.len() - 2;
                let point = [middle(pair), above];
                touches.push(Touching {
                    on: pair_of,
                    against: Some(pair_of + 1),
                    point,
                    normal: [-1.0, 0.0],
                });
            }
            lying.clear();
            for left in 0..(rows - row).saturating_sub(1) {
                let on = centres.len();
                centres.push([0.5 * (middle(left) + middle(left + 1)), above]);
                lying.push(on);
                // A lying card touches both cards of each of the two pairs below its ends.
                for card in 0..4 {
                    let side = if card % 2 == 0 { -0.5 } else { 0.5 };
                    let point = [middle(left + card / 2) + side * APART, above];
                    let against = Some(first + 2 * left + card);
                    touches.push(Touching { on, against, point, normal: [0.0, 1.0] });
                }
            }
        }
        Self { centres, touches }
    }

    /// The number of cards.
    #[must_use]
    pub fn cards(&self) -> usize {
        self.centres.len()
    }

    /// The cards as bodies, with this coefficient of friction at all contacts.
    pub fn bodies(&self, friction: f64) -> Bodies {
        let name = |card: usize| format!("card {card}");
        let bodies = self.centres.iter().enumerate().map(|(card, at)| Body::new(name(card)).mass(MASS, *at));
        let contact = |touch: &Touching| {
            let contact = Contact::new(touch.point, touch.normal).series_stiffness(1e5, 8e4);
            let contact = contact.friction(friction).on(name(touch.on));
            touch.against.map_or(contact.clone(), |against| contact.against(name(against)))
        };
        Bodies::new(bodies).contacts(self.touches.iter().map(contact)).gravity([0.0, -GRAVITY])
    }
}
