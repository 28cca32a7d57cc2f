// Where files come in and go out, and what could not be done is said.
import { meshFile, surfaceIn } from "./files.js";
import { save } from "../page-files.js";

/**
 * @import { Mesh, Surface } from "../../surfaces.js"
 */

/**
 * @typedef {object} DeskPort
 * @property {(surface: Surface) => void} show
 * @property {() => void} changed the message is another one
 * @property {() => Promise<Blob | null>} picture
 * @property {() => { mesh: Mesh, up: "z" | "y" } | null} mesh null before there is one
 * @property {() => { page: Document, name: string }} names where files are handed over, and what they are called
 */

export class Desk {
  #port;
  #message = "";
  /** What is wrong with a file stays until the next one; what is wrong with a setting goes with it. */
  #lasting = false;

  /** @param {DeskPort} port */
  constructor(port) {
    this.#port = port;
  }

  get message() {
    return this.#message;
  }

  /**
   * @param {string} message
   * @param {boolean} [lasting]
   */
  say(message, lasting = false) {
    if (message === this.#message) return;
    [this.#message, this.#lasting] = [message, lasting];
    this.#port.changed();
  }

  /** All went well. */
  clear() {
    if (!this.#lasting) this.say("");
  }

  /**
   * Shows the surface of a file; where there is none in it, says why and leaves all as it was.
   *
   * @param {File} file
   */
  async open(file) {
    try {
      this.#port.show(await surfaceIn(file));
      this.say("");
    } catch (error) {
      this.say(`${file.name}: ${wordsOf(error)}`, true);
    }
  }

  /** @param {"obj" | "stl" | "glb"} kind */
  saveMesh(kind) {
    const found = this.#port.mesh();
    const { page, name } = this.#port.names();
    if (found) save(page, `${name}.${kind}`, meshFile(found.mesh, kind, found.up));
  }

  async savePicture() {
    const blob = await this.#port.picture();
    const { page, name } = this.#port.names();
    if (blob) save(page, `${name}.png`, blob);
  }
}

/**
 * What went wrong, in words.
 *
 * @param {unknown} error
 */
export function wordsOf(error) {
  return error instanceof Error ? error.message : String(error);
}
