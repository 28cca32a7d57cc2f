// The pages of the reference.
import samples from "virtual:reference-samples";
import "./filter.js";
import { defineLiveFigure } from "./live/live-figure.js";

defineLiveFigure(samples);
