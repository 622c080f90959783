//! Shots in real time, served to monitors.
