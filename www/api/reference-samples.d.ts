// The modules that build/vite-samples.js makes.
declare module "virtual:reference-samples" {
  import type { Sources } from "./live/live-figure.js";
  const samples: Sources;
  export default samples;
}
