//! Tells the crate whether it is built for size, as no `cfg` does: at opt-level "s" or "z", `compact` is set.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(compact, small_core)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "s" || level == "z") {
        println!("cargo::rustc-cfg=compact");
    }
}
