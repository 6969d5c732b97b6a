//! The reader of Neutral File Format.
