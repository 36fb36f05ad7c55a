// The dialog with the recipe of all changes, to copy.

import { wholeRecipe } from './live.js';
import { recipeText } from './recipe.js';

const part = (id) => document.getElementById(id);

/** Connects the dialog that shows a recipe of all changes and copies it. */
export function offerRecipe(page) {
  const dialog = part('recipe');
  part('copy-recipe').addEventListener('click', () => {
    if (!page.table) return;
    const text = recipeText(page.live ? wholeRecipe(page.live.recipeFile, page.recipe()) : page.recipe());
    part('recipe-text').value = text;
    const notes = [page.tuning.note()];
    if (page.recipe().material?.base_color && !page.live) notes.push('Where your recipe has a material.base_color, multiply the two.');
    part('recipe-note').textContent = notes.join(' ');
    dialog.showModal();
    part('recipe-text').select();
    navigator.clipboard?.writeText(text).then(() => { part('recipe-done').textContent = 'Copied.'; }, () => {});
  });
  part('close-recipe').addEventListener('click', () => dialog.close());
}
