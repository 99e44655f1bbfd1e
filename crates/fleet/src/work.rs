//! Jobs for any arm: a job for "any arm that has a pen and A5" runs once, on a free arm.

mod choose;
mod engine;
mod kept;
mod settle;
mod shell;
#[cfg(test)]
mod tests;
mod ticket;

pub(crate) use shell::Working;
