#include "cook/select/called.h"

#include "base/text.h"
#include "base/words.h"

#include <array>
#include <initializer_list>
#include <span>

namespace coif::cook {
namespace {

using Words = std::initializer_list<std::string_view>;

bool has(std::string_view name, Words words) { return has_word(name, std::span(words.begin(), words.size())); }

/// A word for hair, whatever else the name says.
bool has_hair(std::string_view name) {
  return has(name, {"hair*",     "*hair",   "fringe*",  "bangs",      "ponytail*", "pigtail*",   "twintail*",
                    "sidetail*", "braid*",  "*braid",   "tress",      "tresses",   "wig",        "wigs",
                    "ahoge",     "bun",     "buns",     "bang",       "topknot",   "mohawk*",    "dreadlock*",
                    "cornrow*",  "kami",    "maegami",  "ushirogami", "haar",      "haare*",     "frisur",
                    "cheveu",    "cheveux", "cabello*", "pelo",       "peluca",    "capelli",    "cabelo*",
                    "wlosy",     "vlasy",   "*髪*",     "*头发*",     "*頭髪*",    "*머리카락*", "*волос*"}) &&
         !has(name, {"*chair", "chair*", "mohair", "hairless*"});
}

}  // namespace

bool is_called_adornment(std::string_view name) {
  return has_hair(name) &&
         has(name, {"*band",      "*bands", "pin",      "pins",    "hairpin*",    "clip*",     "hairclip*",
                    "tie",        "ties",   "hairtie*", "ribbon*", "hairribbon*", "bow",       "bows",
                    "hairbow*",   "net",    "hairnet*", "acc*",    "hairacc*",    "ornament*", "hairorna*",
                    "scrunchie*", "bead",   "beads",    "brush*",  "hairbrush*"});
}

bool is_called_hair(std::string_view name) { return has_hair(name) && !is_called_adornment(name); }

bool is_called_headwear(std::string_view name) {
  return has(name,
             {"hat",      "hats",      "*hat",     "helmet*", "*helmet", "helm",   "cap",      "hood",     "hoodie*",
              "crown*",   "tiara",     "turban",   "beanie",  "mask*",   "visor*", "goggles*", "glasses*", "headphone*",
              "headset*", "headband*", "bandana*", "veil",    "horn",    "horns",  "halo"}) &&
         !has(name, {"haircap", "scalpcap", "what", "that"});
}

bool is_called_skin(std::string_view name) { return has(name, {"skin*", "*skin", "haut", "piel", "hada"}); }

bool is_called_beard(std::string_view name) {
  return has(name, {"*beard", "*beards", "beard*", "mustache*", "moustache*", "goatee*", "whisker*", "sideburn*",
                    "facialhair*", "stubble*", "bart", "barba", "barbe", "hige"});
}

bool is_called_brow(std::string_view name) {
  return has(name, {"brow", "brows", "*eyebrow", "*eyebrows", "eyebrow*", "lash", "lashes", "*eyelash", "*eyelashes",
                    "eyelash*", "mayuge", "matsuge"});
}

bool is_called_eye(std::string_view name) {
  return has(name, {"eye*", "*eye", "*eyes", "blink*", "lid", "lids", "*eyelid", "*eyelids"}) || is_called_brow(name);
}

bool is_called_eyeball(std::string_view name) {
  return has(name, {"*eye", "*eyes", "eyeball*", "*eyeball"}) && !is_called_brow(name) &&
         !has(name, {"blink*",   "lid",    "lids", "*eyelid*", "target*",    "aim",     "look", "ctrl",
                     "control*", "track*", "end",  "nub",      "highlight*", "socket*", "top",  "bottom",
                     "upper",    "lower",  "up",   "low",      "corner*",    "ik"});
}

bool is_called_face_part(std::string_view name) {
  return is_called_eye(name) ||
         has(name, {"*jaw",      "jaw*",    "lip",     "lips",  "*upperlip", "*lowerlip", "*bottomlip", "mouth*",
                    "*mouth",    "tongue*", "*tongue", "nose*", "*nose",     "*cheek",    "cheek*",     "chin",
                    "*masseter", "ear",     "ears",    "teeth", "*caninus",  "facial*"});
}

bool is_called_transparent(std::string_view name) {
  return has(name, {"opacity*", "*opacity", "alpha*", "*alpha", "transp*", "cutout*"}) || matches(name, "*blend_*");
}

bool is_called_head(std::string_view name) {
  return has(name, {"head", "*head", "kopf", "tete", "cabeza", "atama", "*頭", "*голова"}) && !is_called_end(name) &&
         !has_hair(name) &&
         !has(name, {"band", "*band", "phone*", "headphone*", "headband*", "light*", "headlight*", "mesh", "forehead"});
}

bool is_called_end(std::string_view name) { return has(name, {"end", "*end", "top", "nub", "*nub", "tip"}); }

bool is_called_neck(std::string_view name) {
  return has(name, {"neck*", "*neck", "hals", "kubi"}) && !has(name, {"necklace*", "neckline*", "necktie*"});
}

bool is_called_trunk(std::string_view name) {
  return has(name, {"hip", "hips", "pelvis", "spine*", "*spine", "chest*", "*chest", "torso*", "abdomen"});
}

bool is_called_foot(std::string_view name) {
  return has(name, {"*foot", "*feet", "ankle*", "*ankle", "toe*", "*toe", "*toes"});
}

bool is_called_control(std::string_view name) {
  return has(name, {"ik", "pole*", "target*", "ctrl*", "control*", "spring*", "mesh"});
}

bool is_called_limb(std::string_view name) {
  return has(name,
             {"*foot", "*feet", "toe*", "*toe", "*toes", "*hand", "*finger*", "*thumb*", "*thigh", "*calf", "*shin",
              "*knee", "*elbow", "*forearm*", "*upperarm*", "*lowerarm*", "*upleg*", "*upperleg*", "*lowerleg*"});
}

}  // namespace coif::cook
