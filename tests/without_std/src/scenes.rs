//! Pseudo-random grasps, the same on every machine, because they need only additions, products and quotients.
//!
//! Loads are large enough that some grasps slide, some have several equilibria, and some are lost. If there are several equilibria, rounding could
//! decide which one is found; with these loads it does not.

use grasp_lcp::grasp::Contact;
use grasp_lcp::{planar, spatial};

/// A linear congruential generator modulo 2^64, of which only the upper bits are used.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    /// The next number, in [0, 1].
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap_or(0)) / f64::from(u32::MAX)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Cosine and sine of a random angle near the angle of finger `third`, which is 0, 1/3 or 2/3 of a turn.
    fn direction(&mut self, third: usize) -> [f64; 2] {
        let half = self.between(-0.1, 0.1);
        let [cos, sin] = [1.0 - half * half, 2.0 * half].map(|x| x / (1.0 + half * half));
        // Cosine and sine of 0, 1/3 and 2/3 of a turn.
        let [c, s] = [[1.0, 0.0], [-0.5, 0.866_025_403_784_438_6], [-0.5, -0.866_025_403_784_438_6]][third];
        [c * cos - s * sin, s * cos + c * sin]
    }

    /// The contact with random springs, friction and squeeze.
    fn finger<const C: usize>(&mut self, contact: Contact<C>) -> Contact<C> {
        let (normal, tangential) = (self.between(5e2, 3e3), self.between(5e2, 3e3));
        let contact = contact.series_stiffness(normal, tangential);
        contact.friction(self.between(0.4, 1.0)).pressed_with(self.between(8.0, 12.0))
    }

    /// Three fingers around a disc, and a load on it.
    pub(crate) fn planar(&mut self) -> ([planar::Contact; 3], planar::Wrench) {
        let fingers = [0, 1, 2].map(|third| {
            let [x, y] = self.direction(third);
            self.finger(planar::Contact::new([0.05 * x, 0.05 * y], [-x, -y]))
        });
        let force = [self.between(-9.0, 9.0), self.between(-9.0, 9.0)];
        (fingers, planar::Wrench::new(force, self.between(-0.2, 0.2)))
    }

    /// Three fingers around a bottle, and a load on it.
    pub(crate) fn spatial(&mut self) -> ([spatial::Contact; 3], spatial::Wrench) {
        let fingers = [0, 1, 2].map(|third| {
            let [x, y] = self.direction(third);
            let height = self.between(-0.02, 0.02);
            self.finger(spatial::Contact::new([0.05 * x, 0.05 * y, height], [-x, -y, 0.0]))
        });
        let force = [(); 3].map(|()| self.between(-9.0, 9.0));
        (fingers, spatial::Wrench::new(force, [(); 3].map(|()| self.between(-0.1, 0.1))))
    }
}
