// Packages without types that the build of the site uses.

declare module "@11ty/eleventy" {
  export default class Eleventy {
    constructor(input: string, output?: string, options?: { configPath: string; quietMode: boolean });
    toJSON(): Promise<{ url: string; content: string }[]>;
  }
}

declare module "markdown-it-container" {
  const container: import("markdown-it").PluginWithParams;
  export default container;
}

declare module "subset-font" {
  export default function subsetFont(
    font: Uint8Array,
    characters: string,
    options: { targetFormat: "woff2" },
  ): Promise<Uint8Array>;
}

// Libraries that /conformance/ asks.

declare module "bezier-js";
declare module "paper/dist/paper-core.js";
declare module "verb-nurbs";
