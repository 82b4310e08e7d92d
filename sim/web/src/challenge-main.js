/** The script of pages with a challenge: follows the reader's runs of a scene. It starts no Python. */

import { ChallengeElement } from "./question/challenge.js";

customElements.define("carts-challenge", ChallengeElement);
