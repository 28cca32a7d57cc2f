// Chapter 2: the parts of every lesson, the chapter's own figures, and the surfaces that have no name.
import "../figures/index.js";
import "../parts/page.js";
import "./figures/data.js";
import "./figures/differences.js";
import "./figures/knobs.js";
import "./figures/map.js";
import "./figures/player.js";
import "./figures/strip.js";
import "./figures/text.js";
import "./figures/turned.js";
import { fill } from "./figures/surfaces.js";

fill();
