//! What the tiles are set to show, as plain data: a file per view, a field of the scene each.
