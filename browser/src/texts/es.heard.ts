// Español: frases que dice el entorno. Cada una por lo que es en inglés; lo que no está aquí queda en inglés.
// `{0}` es lo primero que varía; `{=0}`, si a su vez es una frase de estas, se traduce también.

export const esHeard: readonly (readonly [RegExp, string])[] = [
  // qué le falta a una aplicación
  [/^(.+) is out of reach: (.+)$/, '{0} está fuera de alcance: {=1}'],
  [
    /^the hand would lean (.+) degrees; this arm only holds it upright, fingers down$/,
    'la mano se inclinaría {0} grados; este brazo solo la sostiene vertical, con los dedos hacia abajo',
  ],
  [
    /^the wrist would be (.+) m from the shoulder, possible are (.+) m$/,
    'la muñeca quedaría a {0} m del hombro, son posibles {1} m',
  ],
  [/^joint (\d+) at (.+) rad is beyond (.+)$/, 'la articulación {0} a {1} rad pasa de {2}'],
  [
    /^expected (\S+) as a vector of length 1, found length (.+)$/,
    'se esperaba {0} como vector de longitud 1; tiene {1}',
  ],
  [
    /^(\S+): (\S+) is the hand at the (left|right), and the arm that moves is (.+)$/,
    '{0}: {1} no es la mano del brazo que se mueve, {3}',
  ],
]
