import "../parts/contents.js";
