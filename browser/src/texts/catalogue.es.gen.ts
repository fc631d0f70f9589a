// Drawn from src/onika/words/text/es/*.toml by tools/generate.py: change those.
export const catalogue: Readonly<Record<string, string>> = {
  "cli.language_option": "el idioma de los mensajes, {languages:or}; {default} si ni esto ni ONIKA_LANG indican otro",
}
