//! Every row of the table of ordinary values has a sane range and a listed source, and is printed.

use crate::{ROOT, run, text};

#[test]
fn every_value_has_a_source_and_a_sane_range() {
    let table = std::fs::read_to_string(format!("{ROOT}/src/bin/grasp-lcp/values.tsv")).expect("is there");
    let printed = text(&run(&["values"]).stdout);
    let rows: Vec<Vec<&str>> =
        table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect()).collect();
    let sources: Vec<&Vec<&str>> = rows.iter().filter(|row| row[0] == "source").collect();
    let mut used = vec![false; sources.len()];
    for row in rows.iter().filter(|row| row[0] != "source") {
        let [quantity, what, from, to, unit, source] = row[..] else { panic!("{row:?}") };
        let [from, to]: [f64; 2] = [from, to].map(|number| number.parse().expect(what));
        let largest = match (quantity, unit) {
            ("friction", "") => 2.0,
            ("stiffness", "N/m") => 1e9,
            // Values without a unit are ratios to another quantity, at most one.
            ("stiffness" | "kinetic", "") => 1.0,
            other => panic!("{other:?}"),
        };
        assert!(0.0 < from && from <= to && to <= largest, "{row:?}");
        assert!(quantity == "friction" || unit.is_empty() || from >= 1e3, "{row:?}");
        let number = sources.iter().position(|known| known[1] == source).unwrap_or_else(|| panic!("{row:?}"));
        used[number] = true;
        assert!(printed.contains(&format!("{what} [{}]", number + 1)), "{what}");
    }
    for (number, source) in sources.iter().enumerate() {
        assert!(source[2].len() > 20 && used[number], "{source:?}");
        assert!(printed.contains(&format!("[{}] {}", number + 1, source[2])), "{source:?}");
    }
    assert!(rows.len() - sources.len() >= 20);
}

/// Printed stiffnesses agree with formulas: Gent's modulus of rubber under a pad, Hertz's stiffness of a tip, and a cantilever.
#[test]
fn formulas_give_the_stiffnesses() {
    let printed = text(&run(&["values"]).stdout);
    let is = |formula: [f64; 2], row: &str| {
        let line = printed.lines().find(|line| line.contains(row)).expect(row);
        let numbers = line.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).take(2);
        for (told, computed) in numbers.zip(formula) {
            assert!((told / computed - 1.0).abs() < 0.05, "{row}: {told} {computed}");
        }
    };
    let modulus = |shore: f64| 1e6 * 0.0981 * (56.0 + 7.66 * shore) / (0.137_505 * (254.0 - 2.54 * shore));
    is([40.0, 80.0].map(|shore| modulus(shore) * 400e-6 / 5e-3), "normal: E A/t");
    is([40.0, 80.0].map(|shore| modulus(shore) / 3.0 * 400e-6 / 5e-3), "a third of that");
    let steel: f64 = 210e9 / (1.0 - 0.09) / 2.0;
    is([100.0, 2000.0].map(|force: f64| (6.0 * 0.01 * steel * steel * force).cbrt()), "E*² F");
    is([0.5, 0.2].map(|nu| 2.0 * (1.0 - nu) / (2.0 - nu)), "2(1 - ν)/(2 - ν)");
    let second_moment = 0.02 * 0.01_f64.powi(3) / 12.0;
    is([70e9, 210e9].map(|modulus| 3.0 * modulus * second_moment / 0.08_f64.powi(3)), "3 E I/L³");
}
