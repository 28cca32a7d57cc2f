// All proofs by the id of their erratum.
import { curveProofs } from "./proofs-curves.js";
import { surfaceProofs } from "./proofs-surfaces.js";

export const proofs = { ...curveProofs, ...surfaceProofs };
