// All figures on one page.
import "../parts/page.js";
import "./index.js";
