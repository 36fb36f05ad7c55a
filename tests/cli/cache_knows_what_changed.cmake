# A cook comes from the cache as long as nothing that it read or looked for has changed. IMAGES: a folder with two pictures.
cmake_minimum_required(VERSION 3.24)
include(${CMAKE_CURRENT_LIST_DIR}/cached_cook.cmake)
write_card(card)
file(COPY_FILE "${IMAGES}/front.png" "${FOLDER}/card.png")

must_take(miss "a first cook" card.obj)
must_take(hit "a second cook" card.obj)
must_take(hit "another spelling of the path" "${FOLDER}/card.obj")

file(COPY_FILE "${IMAGES}/back.png" "${FOLDER}/card.png")
must_take(miss "another texture" card.obj)
file(COPY_FILE "${IMAGES}/front.png" "${FOLDER}/card.png")
must_take(hit "the first texture again" card.obj)

file(APPEND "${FOLDER}/quick.json" "// a comment")
must_take(hit "a comment in the recipe" card.obj)
file(WRITE "${FOLDER}/quick.json" "{\"order\": {\"method\": \"head\"}, \"dynamics\": {\"friction\": 3}}")
must_take(miss "another recipe" card.obj)
file(APPEND "${FOLDER}/card.mtl" "Kd 0.5 0.4 0.3\n")
must_take(miss "another material library" card.obj)
file(APPEND "${FOLDER}/card.obj" "# a line\n")
must_take(miss "another source" card.obj)

file(REMOVE "${FOLDER}/card.png")
must_take(miss "a texture that went" card.obj)
must_take(hit "a texture that is still away" card.obj)
file(WRITE "${FOLDER}/card.txt" "notes")
must_take(hit "a file that nobody looks for" card.obj)
file(MAKE_DIRECTORY "${FOLDER}/textures")
file(COPY_FILE "${IMAGES}/back.png" "${FOLDER}/textures/card.png")
must_take(miss "a texture that appears beside it" card.obj)
file(REMOVE "${FOLDER}/card.mtl")
must_take(miss "a material library that went" card.obj)

# The same things elsewhere are the same.
file(MAKE_DIRECTORY "${FOLDER}/elsewhere")
file(COPY "${FOLDER}/card.obj" "${FOLDER}/textures" DESTINATION "${FOLDER}/elsewhere")
must_take(hit "another folder" elsewhere/card.obj)
