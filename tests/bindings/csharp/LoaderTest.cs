// Which file would be loaded on systems where nobody has tried it? Of the assembly for .NET alone.
#if NET8_0_OR_GREATER
using System.Reflection;
using Ups;
using Xunit;

public sealed class LoaderTest
{
    [Fact]
    public void TestNamesElsewhere()
    {
        var name = typeof(Library).Assembly.GetType("Ups.Loader", true).GetMethod(
            "NameElsewhere", BindingFlags.Static | BindingFlags.NonPublic);
        Assert.Equal("ups_gltf.dll", name.Invoke(null, new object[] { "libups_gltf.so.0.1", true }));
        Assert.Equal("libups.0.1.dylib", name.Invoke(null, new object[] { "libups.so.0.1", false }));
    }
}
#endif
