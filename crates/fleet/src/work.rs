//! Jobs for any arm: a job for "any arm that has a pen and A5" runs once, on a free arm.

mod choose;
mod engine;
mod settle;
mod tasks;
#[cfg(test)]
mod tests;
mod ticket;
mod ticket_store;

pub(crate) use tasks::WorkTasks;
