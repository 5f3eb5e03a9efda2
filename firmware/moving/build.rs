//! The RAM that each program is linked for: more is not there.

/// Each program, and the bytes of its chip's RAM.
const PROGRAMS: [(&str, u32); 2] = [("plasma", 96 << 10), ("scope", 96 << 10)];

fn main() {
    for (program, ram) in PROGRAMS {
        println!("cargo:rustc-link-arg-bin={program}=--defsym=_board_ram={ram}");
    }
    println!("cargo:rerun-if-changed=build.rs");
}
