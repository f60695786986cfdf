//! Entry points of the fuzz targets: a function per reader, and the files that the program writes for it as a beginning.

pub mod readers;
pub mod seeds;
