//! Benchmarks with a station in a separate process, an arm at a pseudo-terminal, and clients.
//!
//! `cargo bench -p dobot-station`, or some of them: `cargo bench -p dobot-station -- stop`.

#[cfg(unix)]
mod latency;
#[cfg(unix)]
mod stop;
#[cfg(unix)]
mod support;
#[cfg(unix)]
mod watchers;

#[cfg(unix)]
fn main() {
    if support::serve() {
        return;
    }
    let words: Vec<String> = std::env::args().skip(1).collect();
    let names: Vec<&String> = words.iter().filter(|word| !word.starts_with('-')).collect();
    let all: [(&str, fn()); 3] = [
        ("latency", latency::measure),
        ("watchers", watchers::measure),
        ("stop", stop::measure),
    ];
    for (name, measure) in all {
        if names.is_empty() || names.iter().any(|wanted| name.contains(wanted.as_str())) {
            println!("{name}");
            measure();
        }
    }
}

#[cfg(not(unix))]
fn main() {
    println!("no pseudo-terminals available, nothing is measured");
}
