//! Modelled cycles of the ways that chips run too.

use xtask::{heading, ways, Build, Chip, Opt};

/// The ways on one chip.
pub(crate) struct OnChip {
    /// Chip, opt-level and compiler.
    pub(crate) heading: String,
    pub(crate) name: &'static str,
    pub(crate) ways: Vec<ways::Way>,
}

impl OnChip {
    /// Cycles of a pixel, and instructions.
    pub(crate) fn cost(&self, family: &str, workload: &str, way: &str) -> Option<(f64, f64)> {
        let named = |w: &&ways::Way| w.family == family && w.workload == workload && w.name == way;
        let way = self.ways.iter().find(named)?;
        Some((way.cycles?, way.instructions))
    }
}

/// Builds the program for the chips and runs it. A chip for which that cannot be done is left out, with a hint.
pub(crate) fn measure() -> Vec<OnChip> {
    let on = |(chip, name)| {
        let build = Build::new(chip, Opt::Three);
        match (heading(build), ways::measure(build)) {
            (Ok(heading), Ok(ways)) => Some(OnChip { heading, name, ways }),
            (Err(error), _) | (_, Err(error)) => {
                eprintln!("{chip} is left out: {error:#}");
                None
            }
        }
    };
    [(Chip::M4, "Cortex-M4"), (Chip::M0, "Cortex-M0+")].into_iter().filter_map(on).collect()
}
