// The materials of the stage, one for each meaning, coloured by the page's tokens.

import { Color, LineBasicMaterial, MeshBasicMaterial, MeshLambertMaterial } from "three";
import type { Look, Token } from "../look";

export class Paints {
  readonly body = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  readonly block = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  readonly edge = new LineBasicMaterial();
  readonly faint = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
  readonly axis = new LineBasicMaterial();
  readonly section = new LineBasicMaterial({ transparent: true, opacity: 0.8 });
  readonly centre = new MeshBasicMaterial();
  readonly limit = new LineBasicMaterial();
  readonly wall = new MeshBasicMaterial({ transparent: true, opacity: 0.22, depthWrite: false });
  readonly ghost = new LineBasicMaterial({ depthTest: false, transparent: true });
  readonly displacement = new MeshBasicMaterial();
  readonly rotation = new MeshBasicMaterial();
  readonly needle = new LineBasicMaterial();

  /** `turning`: whether the sections have a rotation of their own, which has a colour. */
  take(look: Look, turning: boolean): void {
    const colour = (token: Token) => new Color(look.colour(token));
    const between = (share: number) => colour("paper").lerp(colour("ink"), share);
    this.body.color.copy(between(look.dark ? 0.3 : 0.13));
    this.block.color.copy(between(look.dark ? 0.2 : 0.34));
    this.edge.color.copy(between(look.dark ? 0.5 : 0.6));
    this.faint.color.copy(colour("faint"));
    this.axis.color.copy(between(0.24));
    this.section.color.copy(turning ? colour("rotation") : between(0.5));
    this.centre.color.copy(colour("displacement"));
    this.limit.color.copy(colour("constraint"));
    this.wall.color.copy(colour("constraint"));
    this.ghost.color.copy(colour("faint"));
    this.displacement.color.copy(colour("displacement"));
    this.rotation.color.copy(colour("rotation"));
    this.needle.color.copy(colour("rotation"));
  }
}
