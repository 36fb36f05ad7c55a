// The changes made on the page, as a recipe for `coif cook`.

const rounded = (value) => Number(value.toPrecision(6));

function valueOf(control, settings) {
  const values = Array.from(settings.subarray(control.at, control.at + control.count), rounded);
  if (control.kind === 'choice') return control.words.split('|')[values[0]];
  if (control.recipe === 'material.base_color') return [...values, 1];
  return control.count > 1 ? values : values[0];
}

function isChanged(control, settings, original) {
  for (let i = control.at; i < control.at + control.count; ++i) {
    if (settings[i] !== original[i]) return true;
  }
  return false;
}

/** Only settings that have a key in recipes and differ from `original`, the asset's own. */
export function recipeOf(controls, settings, original) {
  const recipe = {};
  for (const control of controls) {
    if (!control.recipe || !isChanged(control, settings, original)) continue;
    const value = valueOf(control, settings);
    if (control.recipe_words && !control.recipe_words.split('|').includes(value)) continue;
    const [section, key] = control.recipe.split('.');
    (recipe[section] ??= {})[key] = value;
  }
  return recipe;
}

export function recipeText(recipe) {
  // Short arrays on one line, as artists write them, and curves.
  const short = JSON.stringify(recipe, null, 2).replace(/\[\s+([^[\]]*?)\s+\]/g, (_, inside) => `[${inside.split(/,\s+/).join(', ')}]`);
  return short.replace(/\[\s+((?:\[[^[\]]*\],?\s+)+)\]/g, (_, inside) => `[${inside.trim().split(/\],\s+/).join('], ')}]`);
}
