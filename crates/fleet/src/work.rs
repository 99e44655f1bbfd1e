//! Work for any arm: what is submitted to "any arm that has a pen and A5" is done once, by one that is free.

mod choose;
mod engine;
mod kept;
mod settle;
mod shell;
#[cfg(test)]
mod tests;
mod ticket;

pub(crate) use shell::Working;
