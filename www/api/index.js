// The names of all entries.
import "../parts/contents.js";
import "./filter.js";
