// The field for a parameter, by its type.

import type { Path } from "../path";
import { AnyField } from "./anyfield";
import { CardList } from "./cards";
import { ChoiceField, CodeField, FileField, SwitchField } from "./choicefields";
import { ComponentField } from "./component";
import type { Described, Field, Form } from "./form";
import { KindField } from "./kind";
import { NumberField } from "./numberfield";
import { TableField } from "./tablefield";
import { TextField } from "./textfields";

export function makeField(form: Form, path: Path, parameter: Described): Field {
  const { type } = parameter;
  switch (type.is) {
    case "number":
    case "integer":
      return new NumberField(form, path, parameter);
    case "boolean":
      return new SwitchField(form, path, parameter);
    case "choice":
      return new ChoiceField(form, path, parameter, type.of);
    case "text":
      return new TextField(form, path, parameter);
    case "file":
      return new FileField(form, path, parameter);
    case "function":
      return new CodeField(form, path, parameter);
    case "list": {
      const { of } = type;
      if (of.is === "kind" || of.is === "component") return new CardList(form, path, parameter, of);
      return new TextField(form, path, parameter);
    }
    case "table":
      return new TableField(form, path, parameter, type.of);
    case "component":
      return new ComponentField(form, path, parameter, type);
    case "kind":
      return new KindField(form, path, parameter, type.family);
    case "any":
      return new AnyField(form, path, parameter, type.of);
  }
}
